#pragma once

#include <array>
#include <cstddef>

#include "make/fit/local_basis.hpp"

/// Sums over the samples of one interval, in vector lanes of fixed order.
namespace batten::fitting {

/// The largest order with a kernel of its own.
constexpr int most_moment_order = 6;

/// A run of samples in memory; `sigma` null: all weights are 1.
struct SampleRun {
    const double* x;
    const double* y;
    const double* sigma;
    std::size_t count;
};

/// Weighted Chebyshev moments: gram[m] = sum w^2 T_m(u), side[j] = sum w^2 y T_j(u).
/// The Gram matrix of T_i, T_j follows without cancellation: (gram[i+j] + gram[|i-j|]) / 2.
struct Moments {
    std::array<double, 2 * most_moment_order - 1> gram{};
    std::array<double, most_moment_order> side{};
    double largest_weight_sq = 1;
};

/// The same bits on every processor: 8 lanes, added up pairwise at the end, no contraction.
Moments chebyshev_moments(const SampleRun& run, LocalScale scale, int order);

/// Sum of w^2 (y - p(u))^2, p given by its Chebyshev coefficients.
double squared_rest(const SampleRun& run, LocalScale scale, int order, const double* p);

/// y - p(u) of every sample, in data units; any order up to num::most_order.
void residuals(const SampleRun& run, LocalScale scale, int order, const double* p, double* out);

}  // namespace batten::fitting
