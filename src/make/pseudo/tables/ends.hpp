#pragma once

#include "make/pseudo/three_point.hpp"

namespace batten::pseudo {

/// A free end from tables, with the derivatives of J along it.
struct TabulatedEnd {
    double theta1 = 0;
    double pseudo_energy = 0;
    double slope = 0;
    double curvature = 0;
};

/// The same as `free_end`. Requires: theta in [-pi, pi].
///
/// Law:      J(-theta) = J(theta) and theta1(-theta) = -theta1(theta), exactly.
/// Accuracy: theta1 1e-10, J 1e-12 relative.   Cost: 15 ns.
TabulatedEnd tabulated_end(double theta);

/// The same as `three_point_angle`, with its laws: Newton's method on the table of J(theta) from a
/// tabulated guess.
///
/// Accuracy: angle 1e-10 relative to the turn, w 1e-12 relative.
/// Cost:     60 to 100 ns, and a `pow` unless the exponent is 1 or the lengths are equal.
ThreePointAngle tabulated_three_point_angle(const ThreePoints& points, double weight_exponent);

}  // namespace batten::pseudo
