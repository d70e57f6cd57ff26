#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "make/interpolate/chords.hpp"
#include "make/interpolate/vectors.hpp"

/// Curves of one cubic a chord, each from its two end tangents: joints are G1, or corners.
namespace batten::interpolation {

/// Points with what is given about them. A point that is a corner has no fixed tangent, unless it
/// is an end of an open curve; tangents are fixed in the plane only.
struct Outline {
    PointsView points;
    Chords chords;
    bool closed = false;
    std::vector<int> corners;
    std::vector<std::optional<double>> angles;  ///< fixed tangents: one entry a point, or none

    std::optional<double> angle(std::size_t i) const {
        return angles.empty() ? std::nullopt : angles[i];
    }
};

/// A stretch of an outline without corners inside. Its neighbours know nothing of it.
struct Run {
    std::vector<std::size_t> indices;  ///< of the outline's points, both ends included
    bool closed = false;               ///< the whole of a closed outline: no ends
};

std::vector<Run> runs_of(const Outline& outline);

/// The points, chords and fixed tangents of a run.
struct RunPoints {
    Points points;
    std::vector<double> lengths;
    std::vector<std::optional<double>> angles;
    bool closed = false;
};

RunPoints points_of(const Outline& outline, const Run& run);

/// Unit tangent vectors at every point, arriving and leaving; they differ at corners.
struct Tangents {
    Points in, out;
};

/// The tangents that a rule for one run makes: RunPoints -> a unit vector for each of its points.
Tangents tangents_by_runs(const Outline& outline,
                          const std::function<std::vector<Vector>(const RunPoints&)>& rule);

/// Tangents parallel to the chord between the two neighbours; at ends, parallel to the chord.
/// Exact fold-back, where the neighbours are one: to the left (in space: any way) of the chord.
Tangents chord_tangents(const Outline& outline);

/// Tangents of the circle through the point and its two neighbours; at ends, of the circle that
/// touches the next tangent. Exact fold-back: as above.
Tangents arc_tangents(const Outline& outline);

/// How long the tangent vectors of each chord are, in chord lengths.
struct Magnitudes {
    std::vector<double> start, end;
};

/// dP/dt where each span starts and ends, if it lasts one unit of t.
struct SpanDerivatives {
    Points start, end;
};

/// A span whose tangents are its chord's direction and whose magnitudes are 1 gets the chord
/// itself: a line at constant speed, exactly.
SpanDerivatives derivatives_of(const Outline& outline, const Tangents& tangents,
                               const Magnitudes& magnitudes);

/// The vector from point i to the next one.
Vector chord_of(const Outline& outline, std::size_t i);

/// The cubics over breaks 0, 1, 2, ...
PiecewiseCubic hermite_curve(const Outline& outline, const SpanDerivatives& derivatives);

}  // namespace batten::interpolation
