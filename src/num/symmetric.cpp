#include "num/symmetric.hpp"

#include <algorithm>
#include <cmath>

namespace batten::num {
namespace {

constexpr int most_sweeps = 30;  // convergence is quadratic: 6 to 10 are usual
constexpr double negligible = 1e-17;

/// The sum of squares below the diagonal, and on it.
struct Weight {
    double below = 0;
    double diagonal = 0;
};

Weight weight_of(const SymmetricMatrix& m) {
    Weight w;
    for (std::size_t i = 0; i < m.size; ++i) {
        w.diagonal += m(i, i) * m(i, i);
        for (std::size_t j = 0; j < i; ++j) w.below += m(i, j) * m(i, j);
    }
    return w;
}

/// Rotates rows and columns p, q so that the entry (p, q) becomes 0.
void rotate(SymmetricMatrix& m, std::size_t p, std::size_t q) {
    if (m(p, q) == 0) return;
    const double tau = (m(q, q) - m(p, p)) / (2 * m(p, q));
    const double t = std::copysign(1.0, tau) / (std::fabs(tau) + std::sqrt(1 + tau * tau));
    const double c = 1 / std::sqrt(1 + t * t), s = t * c;
    for (std::size_t i = 0; i < m.size; ++i) {
        const double a = m(i, p), b = m(i, q);
        m(i, p) = c * a - s * b;
        m(i, q) = s * a + c * b;
    }
    for (std::size_t i = 0; i < m.size; ++i) {
        const double a = m(p, i), b = m(q, i);
        m(p, i) = c * a - s * b;
        m(q, i) = s * a + c * b;
    }
}

}  // namespace

std::vector<double> product(const SymmetricMatrix& matrix, std::span<const double> vector) {
    std::vector<double> result(matrix.size, 0.0);
    for (std::size_t i = 0; i < matrix.size; ++i) {
        for (std::size_t j = 0; j < matrix.size; ++j) result[i] += matrix(i, j) * vector[j];
    }
    return result;
}

std::optional<std::vector<double>> solve_positive(const SymmetricMatrix& matrix,
                                                  std::span<const double> right) {
    const std::size_t n = matrix.size;
    SymmetricMatrix l = matrix;
    std::vector<double> x(right.begin(), right.end());
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = l(i, j);
            for (std::size_t k = 0; k < j; ++k) sum -= l(i, k) * l(j, k);
            if (i == j && !(sum > 0)) return std::nullopt;
            l(i, j) = i == j ? std::sqrt(sum) : sum / l(j, j);
        }
        for (std::size_t k = 0; k < i; ++k) x[i] -= l(i, k) * x[k];
        x[i] /= l(i, i);
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) x[i] -= l(k, i) * x[k];
        x[i] /= l(i, i);
    }
    return x;
}

double least_eigenvalue(SymmetricMatrix matrix) {
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        const Weight w = weight_of(matrix);
        if (w.below <= negligible * negligible * w.diagonal) break;
        for (std::size_t p = 0; p < matrix.size; ++p) {
            for (std::size_t q = p + 1; q < matrix.size; ++q) rotate(matrix, p, q);
        }
    }
    double least = matrix(0, 0);
    for (std::size_t i = 1; i < matrix.size; ++i) least = std::min(least, matrix(i, i));
    return least;
}

}  // namespace batten::num
