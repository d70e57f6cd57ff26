#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/base/tolerance.hpp"

namespace batten {

/// How a curve is walked. docs/sampling.md gives each law's formula.
enum class Law {
    constant,
    accelerate,
    decelerate,
    smoothstep,
    minimum_jerk,
    cosine,
    trapezoid,
    s_curve,
    relative,
    positions,
    keyframes,
    weight,
    curvature,
    curvature_proxy,
    power,
    parameter,
    chord,
    time_optimal,
};

constexpr std::array<Named<Law>, 18> names_of(Law) {
    return {{{"constant", Law::constant},
             {"accelerate", Law::accelerate},
             {"decelerate", Law::decelerate},
             {"smoothstep", Law::smoothstep},
             {"minimum-jerk", Law::minimum_jerk},
             {"cosine", Law::cosine},
             {"trapezoid", Law::trapezoid},
             {"s-curve", Law::s_curve},
             {"relative", Law::relative},
             {"positions", Law::positions},
             {"keyframes", Law::keyframes},
             {"weight", Law::weight},
             {"curvature", Law::curvature},
             {"curvature-proxy", Law::curvature_proxy},
             {"power", Law::power},
             {"parameter", Law::parameter},
             {"chord", Law::chord},
             {"time-optimal", Law::time_optimal}}};
}

enum class SampleMethod {
    exact,            ///< every sample at its arc length to 1e-12 of the whole
    harada_nakamae,   ///< step by step along tangents, then a linear correction [HaradaNakamae]
};

constexpr std::array<Named<SampleMethod>, 2> names_of(SampleMethod) {
    return {{{"exact", SampleMethod::exact}, {"harada-nakamae", SampleMethod::harada_nakamae}}};
}

/// The length that the method of Harada and Nakamae divides among its steps.
enum class WalkedLength { exact, polyline };

constexpr std::array<Named<WalkedLength>, 2> names_of(WalkedLength) {
    return {{{"exact", WalkedLength::exact}, {"polyline", WalkedLength::polyline}}};
}

struct SampleOptions {
    std::optional<int> count;
    std::optional<double> spacing;
    std::optional<double> duration;
    std::optional<double> fps;
    Law law = Law::constant;
    std::optional<double> start_speed, end_speed;
    double ramp = 0.25;
    double accel_time = 0.4;
    double jerk_time = 0.1;
    Points weights = Points(2);
    std::vector<Tolerance> positions;
    Points keys = Points(2);
    std::optional<int> between;
    bool frames = false;
    std::optional<double> curvature_weight;
    std::optional<double> max_speed, max_lateral, max_tangential;
    SampleMethod method = SampleMethod::exact;
    WalkedLength walked_length = WalkedLength::exact;
};

constexpr double most_samples = 1e7;

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, SampleOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("count", o.count, between(2, most_samples), "how many points, both ends included");
    visit("spacing", o.spacing, more_than(0), "no farther apart than this, along the curve");
    visit("duration", o.duration, more_than(0), "the time the whole walk takes");
    visit("fps", o.fps, more_than(0), "points a unit of time, instead of a count");
    visit("law", o.law, anything, "how the curve is walked");
    visit("start_speed", o.start_speed, at_least(0),
          "relative speed at the start (accelerate: 0, decelerate: 1)");
    visit("end_speed", o.end_speed, at_least(0),
          "relative speed at the end (accelerate: 1, decelerate: 0)");
    visit("ramp", o.ramp, Limits{0, 0.5, true},
          "share of the time that speeding up takes, and slowing down (trapezoid)");
    visit("accel_time", o.accel_time, Limits{0, 0.5, true},
          "share of the time that speeding up takes, and slowing down (s-curve)");
    visit("jerk_time", o.jerk_time, Limits{0, 0.25, true},
          "share of the time that the acceleration takes to build up (s-curve)");
    visit("weights", o.weights, anything,
          "one number a step (relative), or rows of arc length and weight: time spent there");
    visit("positions", o.positions, anything,
          "the arc lengths themselves; 0.1r is a share of the length (positions)");
    visit("keys", o.keys, anything, "rows of time and arc length (keyframes)");
    visit("between", o.between, between(0, 1e6),
          "new points in each piece, evenly in its parameter (parameter; polyline length)");
    visit("frames", o.frames, anything, "a frame that does not roll about the curve (space)");
    visit("curvature_weight", o.curvature_weight, at_least(0),
          "C of the density 1 + C |curvature|: samples gather where it bends");
    visit("max_speed", o.max_speed, more_than(0), "speed not to exceed (time-optimal)");
    visit("max_lateral", o.max_lateral, more_than(0),
          "speed^2 |curvature| not to exceed (time-optimal)");
    visit("max_tangential", o.max_tangential, more_than(0),
          "change of speed per time not to exceed (time-optimal)");
    visit("method", o.method, anything,
          "exact on a curve, or the paper's step by step from points");
    visit("walked_length", o.walked_length, anything,
          "the length the paper's method walks: exact, or of a polyline");
}

}  // namespace batten
