#include "num/chebyshev.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace batten::chebyshev {
namespace {

/// The matrix whose column i holds the Chebyshev coefficients of the polynomial f(i, x). Up to
/// degree 20 they are multiples of 2^-40 and made exact by rounding.
template <class F>
std::vector<double> transform(std::size_t degree, F&& f) {
    const std::size_t n = degree + 1;
    std::vector<double> cosines(n * n), values(n * n), matrix(n * n);
    for (std::size_t j = 0; j < n; ++j) {
        const double angle =
            std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(n);
        for (std::size_t k = 0; k < n; ++k) {
            cosines[k * n + j] = std::cos(static_cast<double>(k) * angle);
            values[k * n + j] = f(k, std::cos(angle));
        }
    }
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            double sum = 0;
            for (std::size_t j = 0; j < n; ++j) sum += values[i * n + j] * cosines[k * n + j];
            sum *= (k == 0 ? 1.0 : 2.0) / static_cast<double>(n);
            matrix[k * n + i] = degree <= 20 ? std::round(sum * 0x1p40) * 0x1p-40 : sum;
        }
    }
    return matrix;
}

double chebyshev(std::size_t k, double x) { return std::cos(static_cast<double>(k) * std::acos(x)); }

}  // namespace

Basis::Basis(std::size_t degree)
    : degree_(degree),
      from_bernstein_(transform(degree,
                                [degree](std::size_t i, double x) {
                                    Coefficients unit(degree + 1);
                                    unit[i] = 1;
                                    return bernstein::value(unit, 0.5 + 0.5 * x);
                                })),
      left_(transform(degree,
                      [](std::size_t i, double x) { return chebyshev(i, 0.5 * x - 0.5); })),
      right_(transform(degree,
                       [](std::size_t i, double x) { return chebyshev(i, 0.5 * x + 0.5); })) {}

void Basis::apply(const std::vector<double>& matrix, View in, double* out) const {
    const std::size_t n = degree_ + 1;
    for (std::size_t k = 0; k < n; ++k) {
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i) sum += matrix[k * n + i] * in[i];
        out[k] = sum;
    }
}

int gauss_nodes(double rho, double most, double allowed) {
    const double ratio = 64.0 / 15.0 * most / (allowed * (1 - 1 / (rho * rho)));
    if (!(ratio > 1)) return 2;
    return std::max(2, static_cast<int>(std::ceil(std::log(ratio) / (2 * std::log(rho)))));
}

double gauss_bound(double rho, double most, int n) {
    return 64.0 / 15.0 * most * std::pow(rho, -2.0 * n) / (1 - 1 / (rho * rho));
}

}  // namespace batten::chebyshev
