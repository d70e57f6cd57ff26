#include "make/interpolate/build.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/arc_chain.hpp"
#include "make/interpolate/function.hpp"
#include "make/interpolate/hermite.hpp"
#include "make/interpolate/log_aesthetic.hpp"
#include "make/interpolate/natural_pass.hpp"
#include "make/interpolate/pseudo_spline.hpp"
#include "make/interpolate/spline.hpp"
#include "make/interpolate/windows_and_arcs.hpp"
#include "make/interpolate/vectors.hpp"

namespace batten::interpolation {
namespace {

void require_parameters(std::span<const double> values, std::size_t count) {
    if (values.size() != count) {
        throw Error("interpolate.parameters", "parameter values", std::to_string(values.size()),
                    "these points need " + std::to_string(count));
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!std::isfinite(values[i]) || (i > 0 && !(values[i - 1] < values[i]))) {
            throw Error("interpolate.parameters", "parameter value " + std::to_string(i),
                        format_number(values[i]), "must be finite and strictly increasing", {i});
        }
    }
}

/// The derivative with the fixed direction at an end whose chord has this mean speed.
std::vector<double> clamped(std::optional<double> angle, double speed) {
    if (!angle) return {};
    return {speed * std::cos(*angle), speed * std::sin(*angle)};
}

PiecewiseCubic spline_with(const Outline& outline, std::vector<double> parameters, Ends rule) {
    if (outline.closed) return periodic_spline(outline.points, std::move(parameters));
    SplineEnds ends{rule, {}, {}};
    if (rule == Ends::clamped) {
        const std::size_t last = parameters.size() - 1;
        const std::vector<double>& lengths = outline.chords.lengths;
        ends.first_derivative =
            clamped(outline.angle(0), lengths[0] / (parameters[1] - parameters[0]));
        ends.last_derivative = clamped(
            outline.angle(last), lengths[last - 1] / (parameters[last] - parameters[last - 1]));
    }
    return cubic_spline(outline.points, std::move(parameters), ends);
}

PiecewiseCubic spline_as(const Outline& outline, const InterpolateOptions& options) {
    if (options.parameter_values.empty()) {
        const Parameter rule = options.parameter.value_or(Parameter::chord);
        return spline_with(outline, parameters_by(rule, outline.chords), options.ends);
    }
    require_parameters(options.parameter_values, outline.chords.lengths.size() + 1);
    return spline_with(outline, options.parameter_values, options.ends);
}

PiecewiseCubic natural_spline(const Outline& outline, Parameter parameter) {
    if (parameter == Parameter::chord && !outline.closed) {
        if (auto curve = plain_natural_curve(outline.points)) return *std::move(curve);
    }
    return spline_with(outline, parameters_by(parameter, outline.chords), Ends::natural);
}

PiecewiseCubic hermite_with(const Outline& outline, const Tangents& tangents) {
    const std::vector<double> ones(outline.chords.lengths.size(), 1.0);
    return hermite_curve(outline, derivatives_of(outline, tangents, {ones, ones}));
}

/// What needs no search is always met.
Built plain(Curve curve) { return {std::move(curve), Status::met, {}}; }

void require_rising_x(PointsView points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points(i - 1, 0) < points(i, 0)) continue;
        throw Error("interpolate.x-not-increasing", "point " + std::to_string(i) + ", coordinate 0",
                    format_number(points(i, 0)), "x must be larger than that of the point before",
                    {i});
    }
}

PiecewiseCubic cubic_between(const PiecewiseCubic& curve, IndexRange part) {
    const std::size_t from = static_cast<std::size_t>(part.from);
    const std::size_t to = static_cast<std::size_t>(part.to);
    const std::size_t joints = to - from + 1;
    const std::span<const double> breaks = curve.breaks().subspan(from, joints);
    std::vector<double> block;
    block.reserve(4 * static_cast<std::size_t>(curve.dim()) * joints);
    for (int power = 0; power < 4; ++power) {
        for (int k = 0; k < curve.dim(); ++k) {
            const std::size_t count = power == 0 ? joints : joints - 1;
            const auto kept = curve.coefficients(power, k).subspan(from, count);
            block.insert(block.end(), kept.begin(), kept.end());
            if (power > 0) block.push_back(0);
        }
    }
    return PiecewiseCubic::power(std::move(block), curve.dim(), {breaks.begin(), breaks.end()},
                                 false);
}

}  // namespace

Built built(const Request& request, const InterpolateOptions& options) {
    const Outline& outline = request.outline;
    switch (options.method) {
        case Method::pseudo_spline:
            return pseudo_spline(outline, options);
        case Method::pseudo_spline_global:
            return pseudo_spline_global(outline, options);
        case Method::natural_uniform:
            return plain(natural_spline(outline, Parameter::uniform));
        case Method::natural_chord:
            return plain(natural_spline(outline, Parameter::chord));
        case Method::hermite_chord:
            return plain(hermite_with(outline, chord_tangents(outline)));
        case Method::hermite_arc:
            return plain(hermite_with(outline, arc_tangents(outline)));
        case Method::spline:
            return plain(spline_as(outline, options));
        case Method::pchip:
            require_rising_x(outline.points);
            return plain(pchip_curve(outline.points));
        case Method::makima:
            require_rising_x(outline.points);
            return plain(makima_curve(outline.points));
        case Method::lagrange_2:
            return lagrange_windows(outline, options, 2);
        case Method::lagrange_3:
            return lagrange_windows(outline, options, 3);
        case Method::arc_chain:
            return joined_arcs(outline);
        case Method::log_aesthetic:
            return log_aesthetic(outline, options.alpha);
    }
    throw Error("option.range", "method", std::to_string(static_cast<int>(options.method)),
                "must be one of the methods");
}

Curve between_joints(const Curve& curve, IndexRange part) {
    if (const ArcChain* chain = curve.shape<ArcChain>()) {
        const std::span<const double> breaks = chain->breaks();
        return trimmed(*chain, {breaks[static_cast<std::size_t>(part.from)],
                                breaks[static_cast<std::size_t>(part.to)]});
    }
    return cubic_between(*curve.shape<PiecewiseCubic>(), part);
}

}  // namespace batten::interpolation
