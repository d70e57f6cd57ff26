#pragma once

#include <span>

#include "batten/base/grid.hpp"
#include "batten/make/fit_surface_options.hpp"
#include "batten/make/fit_surface_report.hpp"
#include "batten/shape/spline_surface.hpp"

namespace batten {

/// Measured heights z(r, s) at (x[r], y[s]), x and y strictly rising; nodes may be missing.
///
/// Errors, one standard deviation: x_sigma[r] y_sigma[s] (either empty: 1), or `sigma`, one a node,
/// x slowest. Without them the options say what the errors are.
struct SurfaceSamples {
    std::span<const double> x;
    std::span<const double> y;
    GridView z;
    std::span<const double> x_sigma = {};
    std::span<const double> y_sigma = {};
    std::span<const double> sigma = {};
};

struct SurfaceFit {
    SplineSurface surface;
    FitSurfaceReport report;
};

/// The least-squares tensor-product spline z = S(x, y): minimises
/// delta2 = sum of ((z - S) / sigma)^2 over the nodes that are there.
///
/// Errors of the data, the first that is there: those of the samples, options.sigma, an estimate
/// from mixed second differences (then the criteria are those for unknown sigma).
/// Status `rank_deficient` where a hole in the data leaves a coefficient without a node: it is
/// continued smoothly. `not_met` where a target (distribution, chi2, delta2) was not reached;
/// `not_converged` where conjugate gradients, or free knot
/// lines, stopped early.
///
/// Laws:   (1) z and sigma x 2^k give the same knots and path, and coefficients x 2^k, exactly
///         (2) x or y x 2^k gives the same coefficients, knots x 2^k, exactly
///         (3) x and y exchanged give the exchanged surface, to rounding
/// Accuracy: seminormal equations of the banded QR factors, corrected once where weights or
///         knots are uneven: as good as QR while the matrices have condition numbers below 1e7.
///         Missing nodes and errors that are no product: conjugate gradients until their energy norm
///         has fallen by 1e-11.
/// Cost:   full grids a few operations a node and degree, little more than reading them; all
///         automatic knot lines together once that from 50,000 nodes on, each a few operations a
///         node below. A conjugate-gradient step twice that.
/// Throws: `fit-surface.sizes`, `fit-surface.axis`, `points.not-finite`, `fit.sigma`,
///         `fit.too-few`, `fit.knots`, `fit.intervals`, `fit.distribution`, `fit.options`,
///         `number.overflow`.
/// Source: [Hatano, section 3]; the preconditioner is the inverse for the full grid.
SurfaceFit fit_surface(const SurfaceSamples& samples, const FitSurfaceOptions& options);

}  // namespace batten
