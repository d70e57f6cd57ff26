#include "make/interpolate/request.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::interpolation {
namespace {

/// What a method can do.
struct Abilities {
    int least_dimension = 2;
    int most_dimension = std::numeric_limits<int>::max();
    bool closed = true;
    bool corners = false;
    bool given_parameters = false;
};

Abilities abilities_of(Method method) {
    Abilities able;
    switch (method) {
        case Method::pseudo_spline:
            able.most_dimension = 3;
            break;
        case Method::pseudo_spline_global:
        case Method::log_aesthetic:
            able.most_dimension = 2;
            break;
        case Method::hermite_chord:
        case Method::hermite_arc:
            break;
        case Method::natural_uniform:
        case Method::natural_chord:
            able.least_dimension = 1;
            return able;
        case Method::spline:
            able.least_dimension = 1;
            able.given_parameters = true;
            return able;
        case Method::pchip:
        case Method::makima:
            able.most_dimension = 2;
            able.closed = false;
            return able;
        case Method::lagrange_2:
        case Method::lagrange_3:
            able.least_dimension = 1;
            able.given_parameters = true;
            return able;
        case Method::arc_chain:
            able.most_dimension = 2;
            return able;
    }
    able.corners = true;
    return able;
}

std::string name_of_method(const InterpolateOptions& options) {
    return "method " + std::string(name_of(options.method));
}

void require_abilities(const InterpolateOptions& options) {
    const Abilities able = abilities_of(options.method);
    if (options.closed && !able.closed) {
        throw Error("interpolate.closed-not-taken", name_of_method(options), "closed",
                    "makes curves y(x)");
    }
    if (!options.corner.empty() && !able.corners) {
        throw Error("interpolate.corner-not-taken", name_of_method(options),
                    "corner " + std::to_string(options.corner[0]), "is smooth everywhere");
    }
    if (!options.parameter_values.empty() && !able.given_parameters) {
        throw Error("interpolate.parameters-not-taken", name_of_method(options),
                    std::to_string(options.parameter_values.size()) + " values",
                    "has its own parameters; spline and lagrange methods take them");
    }
    if (!(std::fabs(options.weight_exponent) <= most_weight_exponent)) {
        throw Error("option.range", "weight_exponent", format_number(options.weight_exponent),
                    "must be -8 to 8");
    }
    if (!(std::fabs(options.alpha) <= most_alpha)) {
        throw Error("option.range", "alpha", format_number(options.alpha), "must be -20 to 20");
    }
}

/// A point of the curve, from 0, or the error `code`.
std::size_t index_of(int index, std::size_t count, const std::string& code) {
    if (index < 0 || static_cast<std::size_t>(index) >= count) {
        throw Error(code, "index", std::to_string(index),
                    "must be the index of a point, 0 to " + std::to_string(count - 1));
    }
    return static_cast<std::size_t>(index);
}

/// Whether the curve can be told to run through a point in some direction.
bool takes_tangent(const InterpolateOptions& options, std::size_t index, std::size_t count) {
    if (abilities_of(options.method).corners) return true;
    if (options.method == Method::arc_chain) return index == 0;
    const bool is_clamped = options.method == Method::spline && options.ends == Ends::clamped;
    return is_clamped && !options.closed && (index == 0 || index + 1 == count);
}

void take_tangents(Outline& outline, const InterpolateOptions& options) {
    const std::size_t count = outline.points.size();
    if (!options.tangent.empty()) outline.angles.resize(count);
    for (const FixedTangent& tangent : options.tangent) {
        const std::string place = "tangent " + std::to_string(tangent.index);
        const std::size_t at = index_of(tangent.index, count, "interpolate.tangent-outside");
        if (!takes_tangent(options, at, count)) {
            throw Error("interpolate.tangent-not-taken", place,
                        std::string(name_of(options.method)),
                        "takes no tangent there: pseudo-spline, hermite and log-aesthetic methods do, "
                        "clamped open splines at their ends and an arc-chain at its start");
        }
        if (outline.points.dim() != 2) {
            throw Error("interpolate.tangent-not-taken", place,
                        std::to_string(outline.points.dim()) + " coordinates",
                        "an angle is a direction in the plane only");
        }
        if (!std::isfinite(tangent.angle.radians)) {
            throw Error("option.range", place, format_number(tangent.angle.radians),
                        "must be a finite angle");
        }
        if (outline.angles[at]) {
            throw Error("interpolate.tangent-repeated", place, format_number(tangent.angle.radians),
                        "each point has one tangent at most");
        }
        outline.angles[at] = tangent.angle.radians;
    }
}

void take_corners(Outline& outline, const InterpolateOptions& options) {
    const std::size_t count = outline.points.size();
    for (const int corner : options.corner) {
        const std::size_t at = index_of(corner, count, "interpolate.corner-outside");
        const bool is_end = !outline.closed && (at == 0 || at + 1 == count);
        if (outline.angle(at) && !is_end) {
            throw Error("interpolate.tangent-at-corner", "corner " + std::to_string(corner),
                        format_number(*outline.angle(at)), "a corner has no tangent to fix");
        }
        outline.corners.push_back(corner);
    }
}

void require_part(const InterpolateOptions& options, std::size_t count) {
    if (!options.part) return;
    const std::size_t from = index_of(options.part->from, count, "interpolate.part-outside");
    const std::size_t to = index_of(options.part->to, count, "interpolate.part-outside");
    if (from < to) return;
    throw Error("interpolate.part-empty", "part", std::to_string(from) + "," + std::to_string(to),
                "the second index must be larger than the first");
}

bool same_point(PointsView points, std::size_t i, std::size_t j) {
    return std::equal(points[i].begin(), points[i].end(), points[j].begin());
}

/// Numbers over a parameter may stand still: only chords must not be 0.
bool may_repeat(const InterpolateOptions& options, int dim) {
    if (dim > 1) return false;
    if (options.method == Method::natural_uniform) return true;
    return options.method == Method::spline &&
           (options.parameter == Parameter::uniform || !options.parameter_values.empty());
}

}  // namespace

Request checked_but_for_chords(PointsView points, const InterpolateOptions& options) {
    const Abilities able = abilities_of(options.method);
    require_dimension(points, able.least_dimension, able.most_dimension);
    require_abilities(options);
    Request request;
    const std::size_t rows = points.size();
    if (options.closed && rows > 1 && same_point(points, 0, rows - 1)) {
        points = points.part(0, rows - 1);
        request.notes.push_back("point " + std::to_string(rows - 1) +
                                " repeats point 0 of the closed curve and is left out");
    }
    require_count(points, options.closed ? 3 : 2);
    request.outline.points = points;
    request.outline.closed = options.closed;
    take_tangents(request.outline, options);
    take_corners(request.outline, options);
    require_part(options, points.size());
    return request;
}

Request with_chords(Request request, const InterpolateOptions& options) {
    Outline& outline = request.outline;
    outline.chords = may_repeat(options, outline.points.dim())
                         ? chords_with_repeats(outline.points, outline.closed)
                         : chords_of(outline.points, outline.closed);
    return request;
}

Request checked(PointsView points, const InterpolateOptions& options) {
    return with_chords(checked_but_for_chords(points, options), options);
}

}  // namespace batten::interpolation
