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
/// Tables up to turns of 101.4 degrees, above 50.9 degrees one for each interval of J(theta) that
/// the lighter side's angle may lie in, and the weights at which one passes to the next. Beyond,
/// Newton's method on the table of J(theta), once between any two kinks of w that have a minimum
/// between them: J is convex between its kinks, so none is overlooked.
/// Accuracy: 1e-10 relative to the turn.
/// Cost:     25 ns, above 50.9 degrees 50 ns, above 101.4 degrees 250 ns, and a `pow` unless the
///           exponent is 1 or the lengths are equal.
double tabulated_three_point_angle(const ThreePoints& points, double weight_exponent);

}  // namespace batten::pseudo
