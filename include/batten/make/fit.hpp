#pragma once

#include <span>

#include "batten/make/fit_bands.hpp"
#include "batten/make/fit_options.hpp"
#include "batten/make/fit_report.hpp"
#include "batten/shape/spline_function.hpp"

namespace batten {

/// Measured values y at x with errors sigma (one standard deviation; inf: no weight), in any
/// order, x repeated or not. Without `sigma` the options say what the errors are.
struct FitSamples {
    std::span<const double> x;
    std::span<const double> y;
    std::span<const double> sigma = {};
};

struct Fit {
    SplineFunction spline;
    FitCovariance covariance;
    FitReport report;
};

/// The least-squares spline y(x): minimises delta2 = sum of ((y - S(x)) / sigma)^2.
///
/// Errors of the data, the first that is there: samples.sigma, options.sigma,
/// options.sigma_model, an estimate from differences of neighbours (then the criteria are those
/// for unknown sigma).
/// Knots and their number: see FitOptions. Status `rank_deficient` where coefficients are not
/// determined by the data (given, equal): the spline returned is the one of the least squared
/// differences of order degree + 1 among the best. `not_met` where a target (distribution, chi2,
/// delta2) was not reached.
///
/// Laws:   (1) y and sigma x 2^k give the same knots and path, and coefficients x 2^k, exactly
///         (2) x x 2^k gives the same coefficients, knots x 2^k, exactly
///         (3) for fixed knots the order of the samples changes the result by rounding only
/// Accuracy: that of Householder QR on the weighted B-spline matrix, columns scaled.
/// Cost:   one sort where x is not sorted; fixed knots a few operations a sample and
///         O(intervals degree^3); automatic knots two passes over the data for any number of steps.
/// Throws: `fit.lengths`, `points.not-finite`, `fit.sigma`, `fit.sigma-model`, `fit.too-few`,
///         `fit.x-equal`, `fit.knots`, `fit.intervals`, `fit.distribution`, `option.range`,
///         `fit.options` for options that contradict each other, `number.overflow`, and `Cancelled`
///         where options.progress says so.
/// Source: [Hatano, section 2].
Fit fit(const FitSamples& samples, const FitOptions& options);

}  // namespace batten
