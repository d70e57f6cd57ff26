#pragma once

#include <complex>

#include "batten/shape/log_aesthetic.hpp"

/// One span of an interpolating spline, as its tangents move: everything over the unit chord.
namespace batten::spiral {

/// End curvatures times the arc's length.
struct Bends {
    double start = 0;
    double end = 0;
};

/// An arc whose start tangent stands at an angle to the x axis: where it ends, and how that moves.
struct SpanJet {
    double turn, turn_start, turn_end;                ///< the turn, and by `bends`
    std::complex<double> reach, reach_start, reach_end;  ///< end point of length 1, and by `bends`
};

/// The alpha of a span: as asked where the ratio of its end curvatures, the smaller over the larger
/// one, is above 0.1 + 0.2 |alpha + 1|; -1 (a clothoid) where one vanishes or they differ in sign:
/// no other arc can have an inflection; smoothly between.
double span_alpha(double alpha, Bends bends);

/// Accuracy: 1e-13; derivatives of arcs other than clothoids 1e-6. Cost: 60 ns a clothoid.
SpanJet span_jet(double alpha, double angle, Bends bends);

/// The bends of nearly straight spans whose tangents stand at these angles to the chord.
inline Bends straight_bends(double angle0, double angle1) {
    return {-4 * angle0 - 2 * angle1, 2 * angle0 + 4 * angle1};
}

/// The arc between tangents at these angles to the unit chord, from the bends nearby; false where
/// none is found.
bool settle(double alpha, double angle0, double angle1, Bends& bends);

}  // namespace batten::spiral
