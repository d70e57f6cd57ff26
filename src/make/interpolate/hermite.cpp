#include "make/interpolate/hermite.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "make/interpolate/vectors.hpp"

namespace batten::interpolation {
namespace {

Vector along(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Calls inner(j, before, after) for the points with two neighbours and no fixed tangent.
template <class Inner>
std::vector<Vector> inner_tangents(const RunPoints& run, Inner&& inner) {
    const std::size_t n = run.points.size();
    std::vector<Vector> tangents(n);
    for (std::size_t j = 0; j < n; ++j) {
        if (run.angles[j]) {
            tangents[j] = along(*run.angles[j]);
        } else if (run.closed || (j > 0 && j + 1 < n)) {
            tangents[j] = inner(j, (j + n - 1) % n, (j + 1) % n);
        }
    }
    return tangents;
}

std::vector<Vector> chord_rule(const RunPoints& run) {
    const Points& p = run.points;
    std::vector<Vector> tangents =
        inner_tangents(run, [&](std::size_t j, std::size_t before, std::size_t after) {
            const Vector chord = direction(p[before], p[after]);
            return is_zero(chord) ? across(direction(p[before], p[j])) : chord;
        });
    const std::size_t last = p.size() - 1;
    if (tangents[0].empty()) tangents[0] = direction(p[0], p[1]);
    if (tangents[last].empty()) tangents[last] = direction(p[last - 1], p[last]);
    return tangents;
}

/// The circle's tangent is the direction from neighbour to neighbour, mirrored at the bisector of
/// the two chords: as angles, phi0 + phi1 - phi02.
Vector circle_tangent(const Vector& first, const Vector& second, const Vector& over) {
    if (is_zero(over)) return across(first);
    const bool is_sharp = dot(first, second) < 0;  // then the other bisector is better conditioned
    Vector origin = first;
    if (!is_sharp) {
        for (double& x : origin) x = -x;
    }
    Vector tangent = mirrored(over, direction(origin, second));
    if (is_sharp) {
        for (double& x : tangent) x = -x;
    }
    return tangent;
}

std::vector<Vector> arc_rule(const RunPoints& run) {
    const Points& p = run.points;
    std::vector<Vector> tangents =
        inner_tangents(run, [&](std::size_t j, std::size_t before, std::size_t after) {
            return circle_tangent(direction(p[before], p[j]), direction(p[j], p[after]),
                                  direction(p[before], p[after]));
        });
    const std::size_t last = p.size() - 1;
    const Vector first_chord = direction(p[0], p[1]);
    const Vector last_chord = direction(p[last - 1], p[last]);
    if (last == 1 && tangents[0].empty() && tangents[1].empty()) return {first_chord, last_chord};
    if (tangents[0].empty()) tangents[0] = mirrored(tangents[1], first_chord);
    if (tangents[last].empty()) tangents[last] = mirrored(tangents[last - 1], last_chord);
    return tangents;
}

/// `factor` x the unit tangent, but the chord itself where the tangent is its direction.
void set_derivative(std::span<const double> tangent, std::span<const double> chord, double factor,
                    std::span<double> out) {
    const double length = length_of(chord);
    bool is_along = true;
    for (std::size_t k = 0; k < out.size(); ++k) is_along &= tangent[k] == chord[k] / length;
    for (std::size_t k = 0; k < out.size(); ++k) {
        out[k] = is_along ? factor * chord[k] : factor * length * tangent[k];
    }
}

}  // namespace

std::vector<Run> runs_of(const Outline& outline) {
    const std::size_t n = outline.points.size();
    std::vector<std::size_t> ends(outline.corners.begin(), outline.corners.end());
    if (!outline.closed) {
        ends.push_back(0);
        ends.push_back(n - 1);
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<Run> runs;
    if (ends.empty()) {
        runs.push_back({{}, true});
        for (std::size_t i = 0; i < n; ++i) runs.back().indices.push_back(i);
        return runs;
    }
    if (outline.closed) ends.push_back(ends.front() + n);
    for (std::size_t e = 0; e + 1 < ends.size(); ++e) {
        runs.emplace_back();
        for (std::size_t i = ends[e]; i <= ends[e + 1]; ++i) runs.back().indices.push_back(i % n);
    }
    return runs;
}

RunPoints points_of(const Outline& outline, const Run& run) {
    const std::size_t count = run.indices.size();
    RunPoints result{Points(count, outline.points.dim()), {}, {}, run.closed};
    result.angles.resize(count);
    for (std::size_t j = 0; j < count; ++j) {
        const std::size_t at = run.indices[j];
        std::copy(outline.points[at].begin(), outline.points[at].end(), result.points[j].begin());
        if (run.closed || j + 1 < count) result.lengths.push_back(outline.chords.lengths[at]);
        result.angles[j] = outline.angle(at);
    }
    return result;
}

Tangents tangents_by_runs(const Outline& outline,
                          const std::function<std::vector<Vector>(const RunPoints&)>& rule) {
    const std::size_t n = outline.points.size();
    Tangents result{Points(n, outline.points.dim()), Points(n, outline.points.dim())};
    for (const Run& run : runs_of(outline)) {
        const std::vector<Vector> tangents = rule(points_of(outline, run));
        for (std::size_t j = 0; j < tangents.size(); ++j) {
            const bool starts = j == 0 && !run.closed;
            const bool ends = j + 1 == tangents.size() && !run.closed;
            const std::size_t at = run.indices[j];
            // The ends of an open outline have one tangent; a corner's other side is another run's.
            const bool alone = !outline.closed && (at == 0 || at + 1 == n);
            const auto& t = tangents[j];
            if (!starts || alone) std::copy(t.begin(), t.end(), result.in[at].begin());
            if (!ends || alone) std::copy(t.begin(), t.end(), result.out[at].begin());
        }
    }
    return result;
}

Tangents chord_tangents(const Outline& outline) { return tangents_by_runs(outline, chord_rule); }

Tangents arc_tangents(const Outline& outline) { return tangents_by_runs(outline, arc_rule); }

Vector chord_of(const Outline& outline, std::size_t i) {
    const std::span<const double> from = outline.points[i];
    const std::span<const double> to = outline.points[(i + 1) % outline.points.size()];
    Vector chord(from.size());
    for (std::size_t k = 0; k < chord.size(); ++k) chord[k] = to[k] - from[k];
    return chord;
}

SpanDerivatives derivatives_of(const Outline& outline, const Tangents& tangents,
                               const Magnitudes& magnitudes) {
    const std::size_t spans = outline.chords.lengths.size();
    const int dim = outline.points.dim();
    SpanDerivatives result{Points(spans, dim), Points(spans, dim)};
    for (std::size_t i = 0; i < spans; ++i) {
        const Vector chord = chord_of(outline, i);
        const std::size_t next = (i + 1) % outline.points.size();
        set_derivative(tangents.out[i], chord, magnitudes.start[i], result.start[i]);
        set_derivative(tangents.in[next], chord, magnitudes.end[i], result.end[i]);
    }
    return result;
}

PiecewiseCubic hermite_curve(const Outline& outline, const SpanDerivatives& derivatives) {
    Points joints(outline.points);
    if (outline.closed) joints.push_back(outline.points[0]);
    std::vector<double> breaks(joints.size());
    for (std::size_t i = 0; i < breaks.size(); ++i) breaks[i] = static_cast<double>(i);
    return PiecewiseCubic::hermite(joints, derivatives.start, derivatives.end, std::move(breaks),
                                   outline.closed);
}

}  // namespace batten::interpolation
