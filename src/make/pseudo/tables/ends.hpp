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

/// The angle of `three_point_angle`, with its laws. Requires: turn in [-pi, pi].
///
/// A table up to turns of 50.9 degrees; above, Newton's method on the table of J(theta) from a
/// tabulated guess, once between any two kinks of w that it may lie between.
/// Accuracy: 1e-10 relative to the turn.
/// Cost:     40 ns, above 50.9 degrees 300 ns, and a `pow` unless the exponent is 1 or the lengths
///           are equal.
double tabulated_three_point_angle(const ThreePoints& points, double weight_exponent);

}  // namespace batten::pseudo
