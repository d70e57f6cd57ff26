#pragma once

#include <array>
#include <cstddef>

#include "batten/make/pseudo_segment.hpp"
#include "make/pseudo/local_angles.hpp"

namespace batten::pseudo {

/// The least segment of a pair of angles and what it measures on the unit chord.
struct TabulatedSegment {
    double r0 = 1;
    double r1 = 1;
    double length = 1;         // L
    double pseudo_energy = 0;  // J
};

/// The same as `least_minimum`, from tables. Requires: angles in [-pi, pi].
///
/// Laws:     mirror image and reversal exactly; r0 == r1 for arcs (theta, -theta).
/// Accuracy: J 1e-12 relative, r 1e-8, L 1e-9, all absolute on the unit chord, but
///           * J 1e-9, r and L 1e-6 within 2 degrees of (pi, 0), (pi, pi), (pi, -pi);
///           * r only as well as J knows it where |theta0| and |theta0 + theta1| are below 3
///             degrees, and along the crease of charts.hpp below 10 degrees, where J is so flat that
///             the minimiser itself repeats r to 1e-5 only: the segment's own J is within 1e-11 of
///             the one returned.
///           Where the tables have nothing (one in 10^4 random pairs) the minimiser is called.
/// Cost:     70 to 180 ns; the first call unpacks the tables, 5 ms.
TabulatedSegment tabulated_segment(double theta0, double theta1);

/// The angles of many, and room for what is found.
struct TabulatedBatch {
    static constexpr std::size_t most = 64;
    std::array<double, most> theta0, theta1;
    std::array<TabulatedSegment, most> segments;
};

/// The same numbers for the first `count` of a batch: places are found before any polynomial is
/// worked out, so that memory is not waited for. Cost: 60 to 150 ns each.
void tabulate_segments(TabulatedBatch& batch, std::size_t count);

/// `least_pseudo_segment` by either way. Requires: angles in [-pi, pi].
PseudoSegment least_segment(double theta0, double theta1, Source source);

}  // namespace batten::pseudo
