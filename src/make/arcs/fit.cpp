#include "make/arcs/fit.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/arcs/biarc.hpp"
#include "make/arcs/tangent_chain.hpp"

namespace batten::arc_spline {
namespace {

using plane::Vector;

void require_positive(const std::optional<double>& value, const char* option) {
    if (value && !(*value > 0 && std::isfinite(*value))) {
        throw Error("option.range", option, format_number(*value), "must be above 0 and finite");
    }
}

double jump(const Arc& in, const Arc& out) {
    return std::fabs(
        plane::angle_between(plane::vector(in.end_tangent()), plane::vector(out.start_tangent())));
}

ArcRecord record_of(const Arc& arc, double error) {
    return {arc.start, arc.end, arc.center(), arc.radius(), arc.sweep(), error};
}

void require_finite(const ArcRecord& record, std::size_t index) {
    const auto center = record.center.value_or(std::array<double, 2>{});
    const bool finite = std::isfinite(center[0]) && std::isfinite(center[1]) &&
                        std::isfinite(record.radius.value_or(0)) && std::isfinite(record.error);
    if (!finite) {
        throw Error("number.overflow", "arc " + std::to_string(index), "beyond a double",
                    "scale the points down");
    }
}

}  // namespace

void require_sound(const ArcsOptions& o) {
    require_positive(o.tolerance ? std::optional(o.tolerance->value) : std::nullopt, "tolerance");
    require_positive(o.max_radius, "max_radius");
    for (const std::optional<Angle>& start : {o.start_angle, o.start_normal}) {
        if (start && !std::isfinite(start->radians)) {
            throw Error("option.range", "start", format_number(start->radians), "must be finite");
        }
    }
    if (o.start_angle && o.start_normal) {
        throw Error("arcs.start-twice", "start_normal", format_number(o.start_normal->radians),
                    "give the start's angle or its normal, not both");
    }
}

double radius_limit(const ArcsOptions& options) {
    return options.max_radius.value_or(std::numeric_limits<double>::infinity());
}

std::optional<Vector> asked_start(const ArcsOptions& options, Vector chord) {
    if (options.start_angle) return plane::direction(options.start_angle->radians);
    if (!options.start_normal) return std::nullopt;
    const Vector tangent = -plane::left_of(plane::direction(options.start_normal->radians));
    return plane::dot(tangent, chord) < 0 ? -tangent : tangent;
}

Row chain_row(PointsView points, Vector start, double max_radius) {
    std::vector<double> bulges(points.size() - 1);
    tangent_chain(points, start, bulges);
    Row row;
    row.arcs.reserve(bulges.size());
    for (std::size_t i = 0; i < bulges.size(); ++i) {
        if (!std::isfinite(bulges[i])) {
            throw Error("arcs.chord-against-start", "point " + std::to_string(i),
                        "the next point lies straight behind",
                        "no arc leaves a point forwards and ends behind it: turn the start");
        }
        const Arc arc{{points(i, 0), points(i, 1)}, {points(i + 1, 0), points(i + 1, 1)},
                      bulges[i]};
        row.arcs.push_back(straightened(arc, max_radius));
    }
    row.errors.assign(row.arcs.size(), 0.0);
    return row;
}

ArcFit assembled(const Row& row, bool closed) {
    Points joints(0, 2);
    std::vector<double> bulges;
    joints.reserve(row.arcs.size() + 1);
    bulges.reserve(row.arcs.size());
    for (const Arc& arc : row.arcs) {
        joints.push_back(arc.start);
        bulges.push_back(arc.bulge);
    }
    joints.push_back(closed ? row.arcs.front().start : row.arcs.back().end);
    ArcFit fit{ArcChain(std::move(joints), std::move(bulges), closed), {}};
    ArcsReport& report = fit.report;
    const std::size_t n = fit.chain.arcs();
    report.arc.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Arc arc = fit.chain.arc(i);
        report.arc.push_back(record_of(arc, row.errors[i]));
        require_finite(report.arc.back(), i);
        (arc.is_line() ? report.lines : report.arcs) += 1;
        report.max_error = std::max(report.max_error, row.errors[i]);
        if (std::fabs(arc.bulge) > 1 + 1e-9) report.major_arcs.push_back(i);
        if (i + 1 < n || closed) {
            const double here = jump(arc, fit.chain.arc((i + 1) % n));
            report.max_tangent_jump = std::max(report.max_tangent_jump, here);
        }
    }
    return fit;
}

ArcFit scaled(const ArcFit& fit, double factor) {
    Row row;
    for (std::size_t i = 0; i < fit.chain.arcs(); ++i) {
        Arc arc = fit.chain.arc(i);
        for (double* x : {&arc.start[0], &arc.start[1], &arc.end[0], &arc.end[1]}) *x *= factor;
        row.arcs.push_back(arc);
        row.errors.push_back(fit.report.arc[i].error * factor);
    }
    ArcFit result = assembled(row, fit.chain.is_closed());
    result.report.status = fit.report.status;
    result.report.notes = fit.report.notes;
    return result;
}

double finite_extent(double extent) {
    if (std::isfinite(extent)) return extent;
    throw Error("number.overflow", "points", "extent", "must lie within a double");
}

double safe_scale(double extent) {
    constexpr int usual = 300;  // 2^300 squared, times itself, is still a double
    const int exponent = extent > 0 ? std::ilogb(extent) : 0;
    return std::abs(exponent) > usual ? std::ldexp(1.0, exponent) : 1.0;
}

}  // namespace batten::arc_spline
