#pragma once

#include <span>
#include <vector>

#include "batten/make/fit_options.hpp"
#include "make/fit/samples.hpp"

/// Outliers: weights decided by the residuals, and what a residual costs.
namespace batten::fitting {

/// Reweightings at every refit; with these rejection settles on the Monte Carlo of the tests.
constexpr int most_reweightings = 4;
/// Beyond this share of samples that `reject` would drop, the fit is still too coarse to judge
/// any: nothing is dropped.
constexpr double most_rejected = 0.05;
/// The same of `tukey`, which takes the weights of `huber` then.
constexpr double most_redescended = 0.2;
/// Whether another reweighting would change nothing to speak of.
bool are_alike(std::span<const double> factors, std::span<const double> before);

/// Factors of sigma, one a sample (inf: no weight), from residuals in data units.
std::vector<double> robust_factors(Robust robust, const Samples& samples,
                                   std::span<const double> residuals);

/// The sum over samples of the loss that the weights belong to, e^2 for small e / sigma: what the
/// criteria take for delta2. A rejected sample costs 4^2.
double robust_loss(Robust robust, const Samples& samples, std::span<const double> residuals);

}  // namespace batten::fitting
