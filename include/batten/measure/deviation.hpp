#pragma once

#include <concepts>
#include <type_traits>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/measure/measured.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// Where a curve is compared with something.
struct DeviationPlace {
    double t = 0;               ///< on the curve: the nearest point's parameter
    std::vector<double> point;  ///< what is compared with it
};

template <class Report, class Visit>
    requires std::same_as<std::remove_const_t<Report>, DeviationPlace>
void visit_fields(Report& r, Visit&& visit) {
    visit("t", r.t, "parameter of the nearest point on the curve");
    visit("point", r.point, "the point compared with the curve");
}

/// How far points, or another curve, are from a curve. In the plane a deviation is positive to the
/// left of the curve, negative to its right (straight ahead of an end: positive); elsewhere it is
/// the distance.
struct Deviation {
    double max = 0;   ///< the deviation of largest magnitude
    double rms = 0;   ///< root of the mean square: over the points, or along the other curve
    double mean = 0;  ///< mean of the signed deviations
    double hausdorff = 0;  ///< the largest distance from any point of either to the other
    DeviationPlace at;     ///< where max is
};

/// Deviation of points from a curve.
///
/// Aim:    max, rms, mean: rounding; hausdorff (which asks the curve back: is every place of it
///         near to a point?) within the tolerance, relative ones referring to the curve's extent.
/// Throws: `points.too-few` for none, `points.dimension`, `points.not-finite`; `option.range`;
///         `curve.not-finite`; `number.overflow`.
/// Cost:   about 5 us a point and as much for each of the sub-arcs looked at.
Deviation deviation(const Curve& curve, PointsView points, Tolerance tolerance = relative(1e-6));

/// Deviation of `other` from `curve`: max and hausdorff within the tolerance, rms and mean by
/// quadrature along `other` to about 1e-6 of them. Throws also `curve.dimension`.
Deviation deviation(const Curve& curve, const Curve& other, Tolerance tolerance = relative(1e-6));

/// The Hausdorff distance of two curves: the largest distance from any point of either to the
/// other. |value - distance| <= error <= tolerance, unless that takes more than 10^5 sub-arcs.
///
/// Source: sub-arcs in the order of upper bounds on their distance: the control points' distances
///         from the point nearest to the arc's middle, or from the other curve's arc between the
///         feet of its ends, run through at the same pace.
Measured hausdorff(const Curve& a, const Curve& b, Tolerance tolerance = relative(1e-6));

/// The same for a curve and a set of points.
Measured hausdorff(const Curve& curve, PointsView points, Tolerance tolerance = relative(1e-6));

}  // namespace batten
