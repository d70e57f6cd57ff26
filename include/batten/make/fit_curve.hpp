#pragma once

#include <span>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/make/fit_options.hpp"
#include "batten/make/fit_report.hpp"
#include "batten/shape/bspline.hpp"

namespace batten {

struct CurveFit {
    BSplineCurve curve;
    std::vector<double> parameters;  ///< of the points: where the curve is nearest, in any order
    FitReport report;
};

/// The least-squares B-spline curve near points in the order they are passed, in the plane or in
/// space; closed where options.closed says so (the first point not repeated).
///
/// Minimises delta2 = sum of |P_i - C(t_i)|^2 / sigma_i^2. The t_i start as chord lengths; then, in
/// turn, they move to where the curve is nearest (options.corrections times at most, in order, the
/// ends of an open curve held) and the curve is fitted again. Knots are chosen twice, before and
/// after; those to be moved then move on in turn with the parameters. Errors: `sigma` (one a point;
/// inf: no weight), options.sigma, or estimated from differences of neighbours. options.robust takes
/// distances |P_i - C(t_i)| for residuals; a point that is rejected counts in no chord length.
/// options.fix_ends holds the first and the last point, start_tangent and end_tangent the directions
/// there: the curve of the least delta2 among those that do; what the ends hold is no parameter.
/// In the report residuals are distances. Where parameters are corrected, a point counts as one
/// sample fewer than it has coordinates, and a control point as one parameter fewer: only what lies
/// across the curve is misfit. Without corrections every coordinate counts. There is no band, and
/// coefficients stand coordinate after coordinate.
///
/// Accuracy: a local minimum; t_i to 1e-3 of the gain of the last correction.
/// Cost: (corrections + 2) fits; `free` knots that of a search for each number of them.
/// Throws: `points.dimension` for other than 2 or 3 coordinates, `points.all-equal`, `fit.tangent`,
/// `fit.options` for degree 0 and what makes no sense for a curve, and what `fit` throws.
/// Source: parameter correction [Hoschek1988].
CurveFit fit_curve(PointsView points, std::span<const double> sigma, const FitOptions& options);

}  // namespace batten
