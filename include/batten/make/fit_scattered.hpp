#pragma once

#include <span>

#include "batten/make/fit_surface.hpp"

namespace batten {

/// Heights z[i] at places (x[i], y[i]) in any order; errors sigma[i] (one standard deviation), or
/// none.
struct ScatteredSamples {
    std::span<const double> x, y, z;
    std::span<const double> sigma = {};
};

/// The same spline as `fit_surface` through scattered heights; its domain is their bounding box.
///
/// Coefficients that no sample determines are continued smoothly and listed (`rank_deficient`).
/// The rule `projected` is taken over a quarter of a strip at a time. Without errors the criteria
/// are those for unknown sigma, `sigma` in the report is what is left over, and the rules that need
/// errors (distribution, chi2) are refused.
/// `knots` free moves the lines as `fit_surface` does, all of both directions together; a step that
/// would leave more coefficients undetermined is not taken.
/// `missing` counts nothing, `iterations` the corrections of the factorisation's solution.
///
/// Accuracy: normal equations by sparse Cholesky, corrected by their own residuals until those stand
///         still: as good as QR while the matrix has a condition number below 1e7.
/// Cost:   degree^4 operations a sample, and a factorisation of p coefficients in a band; so much a
///         step where lines move, and L^2 p for L lines.
/// Throws: `fit-surface.sizes`, `points.not-finite`, `fit.sigma`, `fit.too-few`, `fit.x-equal`,
///         `fit.knots`, `fit.intervals`, `fit.distribution`, `fit.options`, `number.overflow`.
SurfaceFit fit_scattered(const ScatteredSamples& samples, const FitSurfaceOptions& options);

}  // namespace batten
