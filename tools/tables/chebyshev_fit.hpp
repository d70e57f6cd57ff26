#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "patch_builder.hpp"

/// Polynomials through Chebyshev's nodes of [-1, 1].
namespace batten::pseudo {

template <std::size_t N>
std::array<double, N> chebyshev_coefficients(const std::array<double, N>& values) {
    std::array<double, N> c{};
    for (std::size_t k = 0; k < N; ++k) {
        for (std::size_t i = 0; i < N; ++i) {
            c[k] += values[i] * std::cos(std::numbers::pi * static_cast<double>(k * (2 * i + 1)) / (2.0 * N)) *
                    (k == 0 ? 1.0 : 2.0) / N;
        }
    }
    return c;
}

template <std::size_t N>
double node(std::size_t i) {
    return std::cos(std::numbers::pi * static_cast<double>(2 * i + 1) / (2.0 * N));
}

template <std::size_t N>
std::array<double, N> powers(const std::array<double, N>& chebyshev) {
    const auto rows = patches::chebyshev_powers(static_cast<int>(N));
    std::array<double, N> c{};
    for (std::size_t k = 0; k < N; ++k) {
        for (std::size_t i = 0; i <= k; ++i) c[i] += chebyshev[k] * rows[k][i];
    }
    return c;
}

/// As powers, from the values at the nodes.
template <std::size_t N>
std::array<double, N> fitted(const std::array<double, N>& values) {
    return powers(chebyshev_coefficients(values));
}

}  // namespace batten::pseudo
