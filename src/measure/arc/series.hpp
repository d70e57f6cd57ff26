#pragma once

#include <array>
#include <cstddef>

#include "num/clones.hpp"

/// Chebyshev sums of a fixed number of terms, made from values at the zeros of T_n. The loops run
/// over the nodes, which compilers turn into vector instructions; the order of every sum is fixed.
namespace batten::arc {

template <std::size_t N>
using Values = std::array<double, N>;

/// What the sums are made with: nodes x_i = cos((i + 1/2) pi / N), the places cos(i pi / N)
/// between them, and the matrix from values at the nodes to coefficients [Trefethen2013, chapter 4].
template <std::size_t N>
struct Nodes {
    Nodes();
    Values<N> at{}, between{};
    std::array<Values<N>, N> to_coefficients{};  ///< row i: what the value at node i adds to each
};

template <std::size_t N>
const Nodes<N>& nodes();

/// The coefficients of the sum with these values at the nodes.
template <std::size_t N>
BATTEN_INLINE void coefficients_of(const Nodes<N>& nodes, const Values<N>& values,
                                       Values<N>& out) {
    for (std::size_t k = 0; k < N; ++k) out[k] = 0;
    for (std::size_t i = 0; i < N; ++i) {
        const double value = values[i];
        for (std::size_t k = 0; k < N; ++k) out[k] += nodes.to_coefficients[i][k] * value;
    }
}

/// The sum's first `terms` terms at every x.
template <std::size_t N>
BATTEN_INLINE void sums_at(const double* c, std::size_t terms, const Values<N>& x,
                               Values<N>& out) {
    Values<N> b1{}, b2{};
    for (std::size_t k = terms; k-- > 1;) {
        for (std::size_t i = 0; i < N; ++i) {
            const double b = c[k] + (2 * x[i] * b1[i] - b2[i]);
            b2[i] = b1[i];
            b1[i] = b;
        }
    }
    for (std::size_t i = 0; i < N; ++i) out[i] = c[0] + (x[i] * b1[i] - b2[i]);
}

}  // namespace batten::arc
