#pragma once

#include <vector>

#include "batten/base/points.hpp"
#include "make/pseudo/local_angles.hpp"
#include "make/pseudo/segment/minima.hpp"

namespace batten::pseudo {

enum class GlobalStatus {
    converged,    // Newton's step has shrunk to the rounding error of the gradient
    out_of_steps  // 200 Newton steps on all spans did not suffice; the best found is returned
};

/// Tangents and magnitudes of all spans, and how they were reached.
struct GlobalSpline {
    std::vector<SpanAngles> spans;
    std::vector<Minimum> minima;  // of each span, on the unit chord
    double energy = 0;            // sum of length^p J
    double gradient = 0;          // largest |d energy / d tangent angle|
    int steps = 0;                // Newton steps on all spans
    GlobalStatus status = GlobalStatus::out_of_steps;
};

/// Tangents that minimise the sum of length^p J over all spans together, p = weight_exponent.
///
/// The sum has many local minima. From the local rule's tangents Newton's method leads to one. Then
/// single spans are passed to their rival shapes (s or c, see `central_minima`) and single tangents
/// turned by 0.3 to either side; what lowers the sum once its neighbourhood has settled is kept,
/// until nothing does. Nothing proves that the result is the least, and where several sums are
/// equal (symmetric points, lopsided minima) the first one found is returned.
///
/// Requires: as `local_angles`.
/// Laws:     points x 2^k give the same angles, magnitudes and number of steps, bit for bit.
/// Accuracy: angles to 1e-10 of that minimum, the sum to 1e-13.
/// Cost:     linear in the points: 10 microseconds a span for each of some ten to fifty Newton
///           steps, and 2 to 5 ms a span for the rivals.
/// Source:   [InoueShibata, section 3], with the gradient by the envelope theorem.
GlobalSpline global_angles(PointsView points, const AngleRules& rules);

}  // namespace batten::pseudo
