#include "make/interpolate/space_pseudo.hpp"

#include <cmath>

#include "batten/make/pseudo_segment.hpp"
#include "make/interpolate/vectors.hpp"
#include "make/pseudo/free_end.hpp"
#include "make/pseudo/tables/ends.hpp"
#include "make/pseudo/tables/segments.hpp"
#include "make/pseudo/three_point.hpp"

namespace batten::interpolation {
namespace {

/// A direction seen from an axis: the angle between them, 0 to pi, and the unit vector across the
/// axis towards which it leans.
struct Leaning {
    double angle = 0;
    Vector side;
};

Leaning leaning(std::span<const double> direction, std::span<const double> axis) {
    const double along = dot(direction, axis);
    Vector side(axis.size());
    for (std::size_t k = 0; k < side.size(); ++k) side[k] = direction[k] - along * axis[k];
    const double length = length_of(side);
    if (length == 0) return {along < 0 ? std::acos(-1.0) : 0, across(axis)};
    for (double& x : side) x /= length;
    return {std::atan2(length, along), side};
}

/// The direction that leans from `axis` towards `side` by `angle`.
Vector turned(std::span<const double> axis, std::span<const double> side, double angle) {
    Vector result(axis.size());
    for (std::size_t k = 0; k < result.size(); ++k) {
        result[k] = std::cos(angle) * axis[k] + std::sin(angle) * side[k];
    }
    return result;
}

Vector inner_tangent(const RunPoints& run, std::size_t j, const SpaceRule& rule) {
    const std::size_t n = run.points.size();
    const std::size_t before = (j + n - 1) % n;
    const Vector first = direction(run.points[before], run.points[j]);
    const Vector second = direction(run.points[j], run.points[(j + 1) % n]);
    const Leaning turn = leaning(second, first);
    const pseudo::ThreePoints three{turn.angle, run.lengths[before], run.lengths[j]};
    const double angle =
        rule.source == pseudo::Source::tables
            ? pseudo::tabulated_three_point_angle(three, rule.weight_exponent)
            : pseudo::three_point_angle(three, rule.weight_exponent).angle;
    return turned(first, turn.side, angle);
}

/// The free end of a chord whose other end has the tangent `next`.
Vector end_tangent(std::span<const double> chord, std::span<const double> next,
                   pseudo::Source source) {
    const Leaning lean = leaning(next, chord);
    const double angle = source == pseudo::Source::tables
                             ? pseudo::tabulated_end(lean.angle).theta1
                             : pseudo::free_end(lean.angle).segment.theta1;
    return turned(chord, lean.side, angle);
}

/// Between the least segments with both tangents on one side, and on opposite sides.
PseudoSegment blended(std::span<const double> chord, std::span<const double> start,
                      std::span<const double> end, pseudo::Source source) {
    const Leaning first = leaning(start, chord), second = leaning(end, chord);
    const double same = 0.5 + 0.5 * dot(first.side, second.side);
    const PseudoSegment one_side =
        pseudo::least_segment(first.angle, second.angle, source);
    const PseudoSegment two_sides =
        pseudo::least_segment(first.angle, -second.angle, source);
    return {first.angle, second.angle, same * one_side.r0 + (1 - same) * two_sides.r0,
            same * one_side.r1 + (1 - same) * two_sides.r1};
}

}  // namespace

Tangents space_tangents(const Outline& outline, const SpaceRule& rule) {
    return tangents_by_runs(outline, [&](const RunPoints& run) {
        const std::size_t last = run.points.size() - 1;
        std::vector<Vector> tangents(last + 1);
        for (std::size_t j = 0; j <= last; ++j) {
            if (run.closed || (j > 0 && j < last)) {
                tangents[j] = inner_tangent(run, j, rule);
            }
        }
        if (run.closed) return tangents;
        const Vector first = direction(run.points[0], run.points[1]);
        const Vector final = direction(run.points[last - 1], run.points[last]);
        tangents[0] = last > 1 ? end_tangent(first, tangents[1], rule.source) : first;
        tangents[last] = last > 1 ? end_tangent(final, tangents[last - 1], rule.source) : final;
        return tangents;
    });
}

Magnitudes space_magnitudes(const Outline& outline, const Tangents& tangents,
                            const SpaceRule& rule) {
    const std::size_t n = outline.points.size();
    Magnitudes result;
    for (std::size_t i = 0; i < outline.chords.lengths.size(); ++i) {
        const std::size_t next = (i + 1) % n;
        const Vector chord = direction(outline.points[i], outline.points[next]);
        const PseudoSegment segment = blended(chord, tangents.out[i], tangents.in[next], rule.source);
        result.start.push_back(segment.r0);
        result.end.push_back(segment.r1);
        rule.progress.at(i + 1, outline.chords.lengths.size());
    }
    return result;
}

}  // namespace batten::interpolation
