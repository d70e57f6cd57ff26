#pragma once

#include <span>

#include "batten/base/points.hpp"

namespace batten {

/// The open curve that `curve_through` makes by the method natural-chord, bit for bit, through many
/// points of the plane (n rows, 2 columns), into the caller's memory: n `breaks`, and in `block` the
/// power coefficients as PiecewiseCubic::power takes them, 8 numbers a point.
///
/// Laws:     points x 2^k give breaks and points of the curve x 2^k, exactly.
/// Accuracy: backward stable.
/// Cost:     three passes over the memory, linear in n; no allocation, unless a chord is so short
///           (2^-52 of the way) that the breaks must be looked at one by one.
/// Throws:   as `curve_through`; `points.dimension` unless there are 2 columns;
///           `curve.coefficients` where `breaks` or `block` are not as long as that.
/// Source:   the equations for the second derivatives [DeBoor2001, IV(5)].
void natural_spline(PointsView points, std::span<double> breaks, std::span<double> block);

}  // namespace batten
