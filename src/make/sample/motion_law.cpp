#include "batten/make/motion_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten {
namespace {

void require_share(const char* name, double x, double most) {
    if (x > 0 && x <= most) return;
    throw Error("option.range", name, format_number(x),
                "must be more than 0 and at most " + format_number(most));
}

/// The second half of a motion that slows down as it has sped up.
template <class FirstHalf>
MotionLaw::Function mirrored(FirstHalf first) {
    return [first](double tau) -> MotionState {
        if (tau <= 0.5) return first(tau);
        const MotionState back = first(1 - tau);
        return {1 - back.share, back.speed};
    };
}

constexpr double ends_tolerance = 1e-9;

}  // namespace

MotionLaw::MotionLaw(Function function) : function_(std::move(function)) {
    for (const double end : {0.0, 1.0}) {
        const double share = function_(end).share;
        if (std::fabs(share - end) <= ends_tolerance) continue;
        throw Error("motion.law-ends", "law at " + format_number(end), format_number(share),
                    "a law starts at 0 and ends at 1");
    }
}

MotionState MotionLaw::at(double tau) const {
    MotionState result = function_(std::clamp(tau, 0.0, 1.0));
    result.share = std::clamp(result.share, 0.0, 1.0);
    return result;
}

MotionLaw MotionLaw::after(const MotionLaw& timing) const {
    return {[inner = timing, outer = *this](double tau) -> MotionState {
                const MotionState time = inner.at(tau);
                const MotionState place = outer.at(time.share);
                return {place.share, time.speed == 0 ? 0 : place.speed * time.speed};
            },
            Trusted{}};
}

MotionLaw MotionLaw::constant() {
    return {[](double tau) -> MotionState { return {tau, 1}; }, Trusted{}};
}

MotionLaw MotionLaw::accelerate(double start, double end) {
    if (!(start >= 0 && end >= 0 && start + end > 0 && std::isfinite(start + end))) {
        throw Error("motion.speeds", "start and end speed",
                    format_number(start) + " and " + format_number(end),
                    "speeds must not be negative, nor both 0");
    }
    const double first = start / (start + end), last = end / (start + end);
    return {[first, last](double tau) -> MotionState {
                return {tau * (2 * first + (last - first) * tau),
                        2 * (first + (last - first) * tau)};
            },
            Trusted{}};
}

MotionLaw MotionLaw::smoothstep() {
    return {[](double tau) -> MotionState {
                return {tau * tau * (3 - 2 * tau), 6 * tau * (1 - tau)};
            },
            Trusted{}};
}

MotionLaw MotionLaw::minimum_jerk() {
    return {[](double tau) -> MotionState {
                const double rest = tau * (1 - tau);
                return {tau * tau * tau * (10 + tau * (6 * tau - 15)), 30 * rest * rest};
            },
            Trusted{}};
}

MotionLaw MotionLaw::cosine() {
    return {[](double tau) -> MotionState {
                const double sine = std::sin(0.5 * std::numbers::pi * tau);
                return {sine * sine, 0.5 * std::numbers::pi * std::sin(std::numbers::pi * tau)};
            },
            Trusted{}};
}

MotionLaw MotionLaw::trapezoid(double ramp) {
    require_share("ramp", ramp, 0.5);
    const double speed = 1 / (1 - ramp);
    return {mirrored([ramp, speed](double tau) -> MotionState {
                if (tau >= ramp) return {speed * (tau - 0.5 * ramp), speed};
                return {speed * tau * tau / (2 * ramp), speed * tau / ramp};
            }),
            Trusted{}};
}

MotionLaw MotionLaw::s_curve(double accel_time, double jerk_time) {
    require_share("accel_time", accel_time, 0.5);
    require_share("jerk_time", jerk_time, 0.5 * accel_time);
    const double speed = 1 / (1 - accel_time);
    const double acceleration = speed / (accel_time - jerk_time);
    const double jerk = acceleration / jerk_time;
    return {mirrored([=](double tau) -> MotionState {
                if (tau >= accel_time) return {speed * (tau - 0.5 * accel_time), speed};
                if (tau <= jerk_time) return {jerk * tau * tau * tau / 6, 0.5 * jerk * tau * tau};
                const double left = accel_time - tau, beyond = tau - jerk_time;
                if (left <= jerk_time) {
                    const double missing = speed * left - jerk * left * left * left / 6;
                    return {0.5 * speed * accel_time - missing,
                            speed - 0.5 * jerk * left * left};
                }
                const double reached = 0.5 * jerk * jerk_time * jerk_time;
                return {reached * jerk_time / 3 + (reached + 0.5 * acceleration * beyond) * beyond,
                        reached + acceleration * beyond};
            }),
            Trusted{}};
}

}  // namespace batten
