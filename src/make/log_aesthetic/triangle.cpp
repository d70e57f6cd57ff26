#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/log_aesthetic.hpp"
#include "shape/log_aesthetic/profile.hpp"
#include "shape/plane.hpp"

namespace batten {
namespace {

using plane::Vector;

Points control_points(const LogAestheticOptions& options) {
    if (options.points.size() != 6) {
        throw Error("log-aesthetic.points", "points",
                    std::to_string(options.points.size()) + " numbers",
                    "must be three points X0,Y0,X1,Y1,X2,Y2");
    }
    if (!(std::fabs(options.alpha) <= 1e3)) {
        throw Error("option.range", "alpha", format_number(options.alpha),
                    "must be at least -1000 and at most 1000");
    }
    Points points(options.points, 2);
    require_finite(points);
    require_distinct(points, true);
    return points;
}

/// rho^(alpha - 1) = 1 + (alpha - 1) lambda theta from rho = 1 at the start.
double lambda_of(double alpha, double log_ratio, double turn) {
    return log_ratio / std::fabs(turn) * spiral::expm1_share((alpha - 1) * log_ratio);
}

LogAestheticMade undrawable(const LogAestheticOptions& options, double chord_angle, double turn) {
    LogAestheticMade made;
    made.report.status = Status::not_met;
    const double degrees = 180 / std::acos(-1.0);
    std::string note = "no arc of alpha " + format_number(options.alpha) +
                       " has these end tangents: the chord stands at " +
                       format_number(std::fabs(chord_angle) * degrees) +
                       " degrees to the first one";
    if (std::fabs(turn) < std::acos(-1.0)) {
        const double most = largest_chord_angle(options.alpha, std::fabs(turn));
        note += "; between " + format_number((std::fabs(turn) - most) * degrees) + " and " +
                format_number(most * degrees) + " degrees are drawable";
    }
    made.report.notes.push_back(std::move(note));
    return made;
}

}  // namespace

LogAestheticMade log_aesthetic(const LogAestheticOptions& options) {
    const Points points = control_points(options);
    const Vector start = plane::at(points, 0), corner = plane::at(points, 1);
    const Vector chord = plane::at(points, 2) - start, first = corner - start;
    const double turn = plane::angle_between(first, plane::at(points, 2) - corner);
    const double chord_angle = plane::angle_between(first, chord);
    const double angle = std::atan2(first.y, first.x);
    std::optional<LogAestheticSegment> arc;
    if (turn == 0) {
        arc = LogAestheticSegment{options.alpha, plane::norm(chord), 0, 0};
    } else if (std::fabs(turn) < std::acos(-1.0)) {
        arc = log_aesthetic_segment(options.alpha, plane::norm(chord), chord_angle, turn);
    }
    if (!arc) return undrawable(options, chord_angle, turn);
    LogAestheticMade made;
    Points joints(0, 2);
    joints.push_back(points[0]);
    joints.push_back(points[2]);
    made.curve.emplace(joints, std::vector{angle}, std::vector{*arc});
    made.report.drawable = true;
    const double ratio = arc->log_radius_ratio();
    made.report.log_radius_ratio = ratio;
    if (turn != 0) made.report.lambda = lambda_of(options.alpha, ratio, turn);
    made.report.length = arc->length;
    made.report.curvatures = std::array{arc->start_curvature, arc->end_curvature};
    return made;
}

}  // namespace batten
