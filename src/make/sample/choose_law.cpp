#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/sample/walk.hpp"

namespace batten::sampling {
namespace {

/// Ends that are typed in may miss the length by this share of it.
constexpr double near = 1e-9;

[[noreturn]] void refuse_missing(const char* name, const char* rule) {
    throw Error("option.missing", name, "not given", rule);
}

[[noreturn]] void refuse(const char* name, std::string value, const char* rule) {
    throw Error("sample.options", name, std::move(value), rule);
}

/// An arc length as a share, with the ends where they are meant.
double share_of(double s, double length) {
    const double share = s / length;
    if (share > 1 && share <= 1 + near) return 1;
    return share;
}

MotionLaw steps_law(const SampleOptions& options) {
    if (options.weights.empty()) refuse_missing("weights", "the law needs one number a step");
    if (options.weights.dim() != 1) {
        refuse("weights", std::to_string(options.weights.dim()) + " columns",
               "law relative takes one column of numbers");
    }
    return MotionLaw::steps(options.weights.coordinates());
}

MotionLaw positions_law(double length, const SampleOptions& options) {
    if (options.positions.empty()) refuse_missing("positions", "the law needs the arc lengths");
    std::vector<double> shares;
    for (const Tolerance& position : options.positions) {
        shares.push_back(position.is_relative ? position.value : share_of(position.value, length));
    }
    return MotionLaw::positions(shares);
}

ChosenLaw keyframes_law(double length, const SampleOptions& options) {
    if (options.keys.empty()) refuse_missing("keys", "the law needs rows of time and arc length");
    Points rows = options.keys;
    for (std::size_t i = 0; i < rows.size() && rows.dim() == 2; ++i) {
        rows(i, 1) = share_of(rows(i, 1), length);
    }
    MotionLaw law = MotionLaw::keyframes(rows);
    const double first = rows(0, 0), last = rows(rows.size() - 1, 0);
    return {std::move(law), last - first, first, std::nullopt};
}

ChosenLaw fastest_law(const Curve& curve, const ArcLengthMap& map, const SampleOptions& options) {
    const auto need = [](const char* name, const std::optional<double>& x) {
        if (!x) refuse_missing(name, "time-optimal needs all three limits");
        return *x;
    };
    const MotionLimits limits{need("max_speed", options.max_speed),
                              need("max_lateral", options.max_lateral),
                              need("max_tangential", options.max_tangential)};
    if (options.duration) {
        refuse("duration", format_number(*options.duration),
               "time-optimal finds the duration itself");
    }
    TimedLaw found = time_optimal_law(curve, map, limits);
    return {std::move(found.law), found.duration, 0, std::nullopt, found.corners};
}

MotionLaw along_time(const ArcLengthMap& map, const Curve& curve, const SampleOptions& options) {
    switch (options.law) {
        case Law::accelerate:
            return MotionLaw::accelerate(options.start_speed.value_or(0),
                                         options.end_speed.value_or(1));
        case Law::decelerate:
            return MotionLaw::accelerate(options.start_speed.value_or(1),
                                         options.end_speed.value_or(0));
        case Law::smoothstep: return MotionLaw::smoothstep();
        case Law::minimum_jerk: return MotionLaw::minimum_jerk();
        case Law::cosine: return MotionLaw::cosine();
        case Law::trapezoid: return MotionLaw::trapezoid(options.ramp);
        case Law::s_curve: return MotionLaw::s_curve(options.accel_time, options.jerk_time);
        case Law::relative: return steps_law(options);
        case Law::positions: return positions_law(map.length(), options);
        case Law::parameter: return parameter_law(curve, map);
        case Law::curvature_proxy: return curvature_proxy_law(curve, map);
        default: return MotionLaw::constant();
    }
}

std::optional<std::size_t> own_count(const Curve& curve, const SampleOptions& options) {
    if (options.law == Law::relative) return options.weights.size() + 1;
    if (options.law == Law::positions) return options.positions.size();
    if (options.law == Law::parameter && options.between) {
        return curve.pieces() * (static_cast<std::size_t>(*options.between) + 1) + 1;
    }
    return std::nullopt;
}

/// What is said of places, whatever the law of the time.
std::optional<PlaceWeights> place_weights(const SampleOptions& options) {
    PlaceWeights weights;
    if (options.law == Law::weight && options.weights.empty()) {
        refuse_missing("weights", "the law needs rows of arc length and weight");
    }
    if (options.law == Law::curvature && !options.curvature_weight) {
        refuse_missing("curvature_weight", "the law needs C of the density 1 + C |curvature|");
    }
    if (options.law != Law::relative) weights.rows = options.weights;
    weights.curvature = options.curvature_weight.value_or(0);
    weights.power = options.law == Law::power;
    if (weights.rows.empty() && weights.curvature == 0 && !weights.power) return std::nullopt;
    return weights;
}

/// An option of one law is refused with another: it would be ignored.
void require_its_law(const SampleOptions& o) {
    const SampleOptions usual;
    const auto require = [&o](bool is_given, const char* name, Law law, Law other) {
        if (!is_given || o.law == law || o.law == other) return;
        const std::string rule = "goes with law " + std::string(name_of(law)) +
                                 (law == other ? "" : " or " + std::string(name_of(other))) +
                                 " only";
        refuse(name, "with law " + std::string(name_of(o.law)), rule.c_str());
    };
    const auto require_one = [&](bool is_given, const char* name, Law law) {
        require(is_given, name, law, law);
    };
    require(o.start_speed.has_value(), "start_speed", Law::accelerate, Law::decelerate);
    require(o.end_speed.has_value(), "end_speed", Law::accelerate, Law::decelerate);
    require_one(o.ramp != usual.ramp, "ramp", Law::trapezoid);
    require_one(o.accel_time != usual.accel_time, "accel_time", Law::s_curve);
    require_one(o.jerk_time != usual.jerk_time, "jerk_time", Law::s_curve);
    require_one(!o.positions.empty(), "positions", Law::positions);
    require_one(!o.keys.empty(), "keys", Law::keyframes);
    require_one(o.max_speed.has_value(), "max_speed", Law::time_optimal);
    require_one(o.max_lateral.has_value(), "max_lateral", Law::time_optimal);
    require_one(o.max_tangential.has_value(), "max_tangential", Law::time_optimal);
}

void require_range(const char* name, double x, const Limits& limits) {
    if (limits.accept(x) && std::isfinite(x)) return;
    throw Error("option.range", name, format_number(x),
                (limits.lo_open ? "must be more than " : "must be at least ") +
                    format_number(limits.lo) + " and at most " + format_number(limits.hi));
}

}  // namespace

void require_ranges(const SampleOptions& options) {
    const auto check = [](const char* name, const auto& member, const Limits& limits,
                          const char*) {
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (std::is_arithmetic_v<Member> && !std::is_same_v<Member, bool>) {
            require_range(name, member, limits);
        } else if constexpr (std::is_same_v<Member, std::optional<int>> ||
                             std::is_same_v<Member, std::optional<double>>) {
            if (member) require_range(name, *member, limits);
        }
    };
    visit_fields(options, check);
}

ChosenLaw choose_law(const Curve& curve, const ArcLengthMap& map, const SampleOptions& options) {
    require_its_law(options);
    const std::optional<PlaceWeights> weights = place_weights(options);
    const bool knows_places = options.law == Law::chord || options.law == Law::time_optimal ||
                              options.law == Law::positions || options.law == Law::parameter ||
                              options.law == Law::curvature_proxy || options.law == Law::keyframes;
    if (weights && knows_places) {
        refuse("law", std::string(name_of(options.law)), "this law leaves no room for weights");
    }
    if (options.law == Law::keyframes) return keyframes_law(map.length(), options);
    if (options.law == Law::time_optimal) return fastest_law(curve, map, options);
    MotionLaw law = along_time(map, curve, options);
    if (weights) law = weighted_law(curve, map, *weights).after(law);
    return {std::move(law), std::nullopt, 0, own_count(curve, options)};
}

Timing timing_of(const ChosenLaw& chosen, double length, const SampleOptions& options) {
    const int given = int(options.count.has_value()) + int(options.spacing.has_value()) +
                      int(options.fps.has_value());
    if (given > 1) refuse("count", "and others", "give one of count, spacing and fps");
    if (given == 0 && !chosen.samples) {
        refuse_missing("count", "or spacing, or duration and fps: how many points are wanted");
    }
    if (given == 1 && chosen.samples) {
        const bool agrees =
            options.count && static_cast<std::size_t>(*options.count) == *chosen.samples;
        if (!agrees) {
            refuse("law", std::to_string(*chosen.samples) + " points",
                   "this law says itself how many points there are");
        }
    }
    Timing timing{{}, options.duration.value_or(chosen.duration.value_or(1)),
                  options.duration ? 0 : chosen.start};
    if (options.fps && !options.duration && !chosen.duration) {
        refuse_missing("duration", "points a unit of time need the whole time");
    }
    // A last step that is this small beside the others is none.
    constexpr double small = 1e-9;
    double steps = options.fps ? timing.duration * *options.fps
                   : options.spacing ? length / *options.spacing
                   : chosen.samples  ? static_cast<double>(*chosen.samples) - 1
                                     : options.count.value_or(2) - 1;
    const double whole = std::fmax(std::ceil(steps - small * steps), 1);
    if (!(whole < most_samples)) {
        throw Error("option.range", options.fps ? "fps" : "spacing", format_number(whole + 1),
                    "more points than " + format_number(most_samples));
    }
    if (!options.fps) steps = whole;
    for (double i = 0; i < whole; ++i) timing.tau.push_back(i / steps);
    timing.tau.push_back(1);
    return timing;
}

}  // namespace batten::sampling
