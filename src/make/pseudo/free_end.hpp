#pragma once

#include <vector>

#include "batten/make/pseudo_segment.hpp"

namespace batten::pseudo {

/// A local minimum of J over theta1, r0, r1 for a given theta0: the far end of the chord is free.
struct FreeEnd {
    PseudoSegment segment;
    double pseudo_energy = 0;  // J(theta)
    double slope = 0;          // dJ / d theta along this minimum (envelope theorem)
    double curvature = 0;      // d2J / d theta2 along it
    bool is_converged = true;
};

/// The least minimum: J(theta) and, as segment.theta1, theta1(theta) of [InoueShibata, eq. 11, 12].
///
/// Laws:     J(-theta) = J(theta) and theta1(-theta) = -theta1(theta), exactly; at theta = pi,
///           where both signs of theta1 are least, it is negative.
/// Accuracy: J to 1e-14, theta1 to 1e-12. J is continuous; theta1 and the slope jump where the
///           least minimum passes to another (near 50.8, 55.7 and 61.0 degrees).
/// Cost:     about 45 evaluations with Hessian, 0.1 ms.
FreeEnd free_end(double theta);

/// The minima that can be the least, the least first: at most three, one for theta < 0.7.
std::vector<FreeEnd> free_end_minima(double theta);

/// The minimum whose valley `start` lies in, for theta0 = `theta`.
FreeEnd free_end_near(double theta, const PseudoSegment& start);

}  // namespace batten::pseudo
