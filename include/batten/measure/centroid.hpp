#pragma once

#include <vector>

#include "batten/base/tolerance.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// The centre of gravity of the curve as a wire of constant thickness: (1/L) int r ds. The point
/// itself where the curve is a single point.
///
/// Aim:    error <= tolerance in each coordinate, relative ones referring to the extent.
/// Throws: as `length`.
std::vector<double> centroid(const Curve& curve, Tolerance tolerance = relative(1e-12));

}  // namespace batten
