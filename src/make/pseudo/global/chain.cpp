#include "make/pseudo/global/chain.hpp"

#include <cmath>

namespace batten::pseudo {
namespace {

/// The diagonal of matrix + shift D; D is 1 where a row is zero.
std::vector<double> shifted_diagonal(const ChainMatrix& matrix, double shift) {
    const std::size_t n = matrix.diagonal.size();
    std::vector<double> diagonal = matrix.diagonal;
    for (std::size_t i = 0; i < n; ++i) {
        const double row = std::fabs(matrix.diagonal[i]) + std::fabs(matrix.beside[i]) +
                           std::fabs(matrix.beside[(i + n - 1) % n]);
        diagonal[i] += shift * (row > 0 ? row : 1);
    }
    return diagonal;
}

}  // namespace

std::optional<std::vector<double>> solve_shifted(const ChainMatrix& matrix, double shift,
                                                 const std::vector<double>& right_side) {
    const std::size_t n = matrix.diagonal.size();
    std::vector<double> x = right_side;
    if (n == 0) return x;
    const std::size_t last = n - 1;
    std::vector<double> pivot = shifted_diagonal(matrix, shift);
    std::vector<double> next = matrix.beside;  // entries between i and i + 1
    std::vector<double> closing(n, 0.0);       // entries between i and the last unknown
    if (last > 0) {
        closing[0] = matrix.beside[last];
        closing[last - 1] += next[last - 1];
        next[last - 1] = 0;
    }
    for (std::size_t i = 0; i < last; ++i) {
        if (!(pivot[i] > 0)) return std::nullopt;
        const double to_next = next[i] / pivot[i];
        const double to_last = closing[i] / pivot[i];
        if (i + 1 < last) {
            pivot[i + 1] -= to_next * next[i];
            closing[i + 1] -= to_next * closing[i];
            x[i + 1] -= to_next * x[i];
        }
        pivot[last] -= to_last * closing[i];
        x[last] -= to_last * x[i];
    }
    if (!(pivot[last] > 0)) return std::nullopt;
    x[last] /= pivot[last];
    for (std::size_t i = last; i-- > 0;) {
        x[i] -= closing[i] * x[last] + (i + 1 < last ? next[i] * x[i + 1] : 0.0);
        x[i] /= pivot[i];
    }
    return x;
}

}  // namespace batten::pseudo
