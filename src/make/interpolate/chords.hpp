#pragma once

#include <span>
#include <vector>

#include "batten/base/points.hpp"

namespace batten::interpolation {

/// Distances between consecutive points, from the last to the first too where the curve is closed.
struct Chords {
    std::vector<double> lengths;
    double shortest = 0;
    double longest = 0;
};

/// Accuracy: one rounding of the sum of squares and one of the root, whatever the exponents.
/// Laws: points x 2^k give lengths x 2^k, exactly. Cost: one root a chord.
/// Throws `points.not-finite`, `points.all-equal`, `points.repeated`, and `number.overflow` where
/// a chord is beyond a double. At least two points.
Chords chords_of(PointsView points, bool closed);

/// The same where points may repeat: a chord may be 0.
Chords chords_with_repeats(PointsView points, bool closed);

/// The length of a vector, without overflow or underflow on the way.
double length_of(std::span<const double> vector);

}  // namespace batten::interpolation
