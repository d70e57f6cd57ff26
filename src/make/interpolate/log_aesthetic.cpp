#include "make/interpolate/log_aesthetic.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "batten/base/text.hpp"
#include "make/log_aesthetic/spline.hpp"

namespace batten::interpolation {
namespace {

spiral::SplineRun spline_run(const Outline& outline, const Run& run) {
    RunPoints part = points_of(outline, run);
    spiral::SplineRun result{std::move(part.lengths), {}, {}, run.closed};
    if (!outline.angles.empty()) result.fixed = std::move(part.angles);
    for (std::size_t j = 0; j < result.lengths.size(); ++j) {
        const auto from = part.points[j], to = part.points[(j + 1) % part.points.size()];
        result.directions.push_back(std::atan2(to[1] - from[1], to[0] - from[0]));
    }
    return result;
}

/// What became of all runs together.
struct Summary {
    std::size_t held = 0, other_alphas = 0, unsettled = 0;
    double jump = 0;

    void add(const spiral::SplineChain& chain) {
        held += chain.held;
        other_alphas += chain.other_alphas;
        unsettled += !chain.converged;
        jump = std::fmax(jump, chain.jump);
    }
};

void report(const Summary& summary, double alpha, Built& built) {
    if (summary.held > 0) {
        built.status = Status::not_met;
        built.notes.push_back("at " + std::to_string(summary.held) +
                              " points the tangent is kept at 137 degrees to a chord, where arcs "
                              "would become loops: there the curvature jumps");
    }
    if (summary.unsettled > 0) {
        built.status = Status::not_converged;
        built.notes.push_back("the search for the tangents stopped early: the curvature jumps by "
                              "up to " +
                              format_number(summary.jump) + " over the shorter chord beside");
    }
    if (summary.other_alphas > 0) {
        built.notes.push_back(std::to_string(summary.other_alphas) +
                              " spans have another alpha than " + format_number(alpha) +
                              ", towards -1: they have an inflection, or nearly so");
    }
}

}  // namespace

Built log_aesthetic(const Outline& outline, double alpha) {
    const std::size_t spans = outline.chords.lengths.size();
    std::vector<double> angles(spans);
    std::vector<LogAestheticSegment> segments(spans);
    Summary summary;
    for (const Run& run : runs_of(outline)) {
        const spiral::SplineChain chain =
            spiral::log_aesthetic_spline(spline_run(outline, run), alpha);
        for (std::size_t j = 0; j < chain.segments.size(); ++j) {
            angles[run.indices[j]] = chain.angles[j];
            segments[run.indices[j]] = chain.segments[j];
        }
        summary.add(chain);
    }
    Points joints(outline.points);
    if (outline.closed) joints.push_back(outline.points[0]);
    Built built{LogAestheticCurve(joints, std::move(angles), std::move(segments), outline.closed),
                Status::met,
                {}};
    report(summary, alpha, built);
    return built;
}

LogAestheticCurve between_joints(const LogAestheticCurve& curve, IndexRange part) {
    const std::size_t from = static_cast<std::size_t>(part.from);
    const std::size_t count = static_cast<std::size_t>(part.to) - from;
    const auto angles = curve.angles().subspan(from, count);
    const auto segments = curve.segments().subspan(from, count);
    return {curve.joints().view().part(from, count + 1),
            {angles.begin(), angles.end()},
            {segments.begin(), segments.end()}};
}

}  // namespace batten::interpolation
