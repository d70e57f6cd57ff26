#pragma once

#include <optional>

#include "batten/base/points.hpp"
#include "batten/shape/piecewise_cubic.hpp"

namespace batten::interpolation {

/// The natural spline by chords in the plane, in few passes over the memory; the bits of
/// `cubic_spline`. Nothing in other dimensions, and where chords are so short or long, or no
/// numbers, that they must be looked at one by one. At least two points.
std::optional<PiecewiseCubic> plain_natural_curve(PointsView points);

}  // namespace batten::interpolation
