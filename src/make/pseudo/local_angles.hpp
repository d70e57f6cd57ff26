#pragma once

#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/base/progress.hpp"

namespace batten::pseudo {

/// Where least minima come from.
enum class Source {
    minimiser,
    tables  // within the accuracy of tables/ends.hpp
};

/// What is asked of the tangents; indices as the public options have them.
struct AngleRules {
    bool is_closed = false;
    double weight_exponent = 1;
    std::vector<FixedTangent> tangents;  // absolute directions
    std::vector<int> corners;            // points where both sides end freely
    Progress progress = {};
    Source source = Source::minimiser;
};

/// A chord between neighbouring points and the end tangents of its span.
struct SpanAngles {
    double length = 0;     // of the chord
    double direction = 0;  // phi: absolute angle of the chord
    double theta0 = 0;     // tangent at the start, from the chord, in (-pi, pi]
    double theta1 = 0;     // tangent at the end, from the chord

    double start_tangent() const { return direction + theta0; }  // psi, modulo 2 pi
    double end_tangent() const { return direction + theta1; }
};

/// The chords of a polyline (of a polygon if closed: the last one leads back to the first point),
/// with zero angles.
///
/// Laws: points x 2^k give lengths x 2^k and the same directions, bit for bit, while the squares of
/// the scaled differences do not leave the range of double.
std::vector<SpanAngles> chords(PointsView points, const AngleRules& rules);

/// The tangents of the local pseudo-spline: at every inner point by the rule of three points, at
/// ends and at both sides of corners by the free end of the neighbouring span, where fixed as
/// given. A span with both ends free is straight.
///
/// Requires: two-dimensional points, neighbours distinct; at least 2, closed 3 points. The caller
/// checks.
/// Laws:     the tangent at a point depends on it and its two neighbours alone (an end: on the
///           first or last three points). Equal chords and equal turns give exactly equal angles.
/// Accuracy: 1e-12, from tables 1e-10.
/// Cost:     about 0.5 ms a point, 0.1 ms where neighbouring chords are equal; from tables 0.1 us.
/// Source:   [InoueShibata, eq. 11, 12], in angles from the two chords of a point.
std::vector<SpanAngles> local_angles(PointsView points, const AngleRules& rules);

}  // namespace batten::pseudo
