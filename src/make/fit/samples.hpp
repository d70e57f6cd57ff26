#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/make/fit.hpp"
#include "make/fit/work.hpp"

namespace batten::fitting {

constexpr int most_sides = 4;

/// A run of samples.
struct Rows {
    std::size_t first = 0;
    std::size_t last = 0;

    std::size_t count() const { return last - first; }
};

/// What a fit works on: samples in rising x, none without weight. Borrows the caller's memory
/// where that is already so, and owns copies where not.
struct Samples {
    std::span<const double> x;
    std::vector<std::span<const double>> sides;  ///< one a dependent coordinate
    std::span<const double> sigma;               ///< empty where all are `common_sigma`
    double common_sigma = 1;
    bool sigma_known = false;
    bool are_feet = false;           ///< x: where a curve is nearest to its points
    bool has_weightless = false;                 ///< among the samples as they were given
    SigmaSource source = SigmaSource::estimated;
    double least_delta2 = 0;         ///< what rounding leaves; 0 where sigma is known
    Work work;                       ///< told at every refit
    Interval range;                  ///< of all x, weightless ones included
    std::vector<std::size_t> row_of; ///< the caller's row of each sample; empty: the same
    std::vector<std::vector<double>> owned;

    std::size_t size() const { return x.size(); }
    /// The sides in which a sample, and a coefficient, counts: across the curve alone where the
    /// abscissae are feet of the samples.
    std::size_t directions() const { return sides.size() - (are_feet ? 1 : 0); }
    /// What counts as N.
    std::size_t values() const { return x.size() * directions(); }
    double sigma_at(std::size_t i) const { return sigma.empty() ? common_sigma : sigma[i]; }
    std::size_t row(std::size_t i) const { return row_of.empty() ? i : row_of[i]; }

    Samples() = default;
    Samples(Samples&&) = default;
    Samples& operator=(Samples&&) = default;
};

/// Checks, sorts (stably, once, only where needed) and drops what has weight 0.
///
/// Throws `fit.lengths`, `points.not-finite`, `fit.sigma`, `fit.too-few`, `fit.x-equal`, and what
/// require_units throws.
Samples prepared(const FitSamples& given, const FitOptions& options);

/// The same of some of the samples of a fit over `domain`: there may be one, or none, or all at one
/// abscissa. Errors are known.
Samples prepared_part(const FitSamples& given, const FitOptions& options, Interval domain);

/// The samples as they are, believed to be in order: for a caller who looks while reading them (see
/// FirstLook). Nothing where that is out of the question, or where the range or a sigma to be
/// taken for all is amiss; then prepared() tells.
std::optional<Samples> believed(const FitSamples& given, const FitOptions& options);

/// Throws `number.overflow` where squares of y / sigma, or derivatives, would be beyond a double:
/// then units are to be changed. `largest`: of all |y|.
void require_units(const Samples& samples, double largest, int degree);

/// Takes `noise` for the error of every ordinate, or what rounding is where there is less.
void estimate_sigma(Samples& samples, double noise, double largest);

/// The same samples with other weights: sigma x `factor`, inf dropping the sample.
Samples reweighted(const Samples& samples, std::span<const double> factor);

/// Noise level from second differences of neighbours, as a root mean square.
/// Source: [GasserSrokaJennenSteinmetz1986, eq. 3].
double noise_from_differences(std::span<const double> x, std::span<const double> y);

}  // namespace batten::fitting
