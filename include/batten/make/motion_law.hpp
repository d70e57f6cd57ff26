#pragma once

#include <functional>
#include <span>
#include <utility>

#include "batten/base/points.hpp"

namespace batten {

/// Where a motion is and how fast: the share of the way, and its derivative by tau.
struct MotionState {
    double share = 0;
    double speed = 0;
};

/// How far a motion has come at a time: share of the way s / L against tau = time / duration, both
/// in [0, 1]. It knows nothing of the curve that is walked.
///
/// Laws never walk back. Accuracy of `at`: a few ulps, but where something else is said.
class MotionLaw {
public:
    using Function = std::function<MotionState(double tau)>;

    /// A law from the user's own function; it must be finite and not fall over [0, 1]. Throws
    /// `motion.law-ends` unless the share is 0 at tau = 0 and 1 at tau = 1, both within 1e-9.
    explicit MotionLaw(Function function);

    /// tau.
    static MotionLaw constant();
    /// The speed changes evenly from `start` to `end` (only their ratio counts): (0, 1) starts
    /// from rest, (1, 0) ends in rest. Throws `motion.speeds` where one is negative or both are 0.
    static MotionLaw accelerate(double start, double end);
    /// 3 tau^2 - 2 tau^3.
    static MotionLaw smoothstep();
    /// 10 tau^3 - 15 tau^4 + 6 tau^5: least jerk from rest to rest [FlashHogan1985].
    static MotionLaw minimum_jerk();
    /// (1 - cos pi tau) / 2.
    static MotionLaw cosine();
    /// Even acceleration over the share `ramp` of the time, even speed, even deceleration. Throws
    /// `option.range` unless 0 < ramp <= 1/2.
    static MotionLaw trapezoid(double ramp);
    /// The seven phases of bounded jerk: accelerating for `accel_time`, of which the first and the
    /// last `jerk_time` with constant jerk; slowing down likewise. Throws `option.range` unless
    /// 0 < accel_time <= 1/2 and 0 < jerk_time <= accel_time / 2.
    static MotionLaw s_curve(double accel_time, double jerk_time);

    /// One number a step: how long each is beside the others; all take the same time. Throws
    /// `motion.weights` unless all are finite, none negative and their sum above 0.
    static MotionLaw steps(std::span<const double> weights);
    /// The shares at evenly spaced times, the first and the last included; even speed between.
    /// Throws `motion.positions` unless there are two or more, in [0, 1] and not falling.
    static MotionLaw positions(std::span<const double> shares);
    /// Rows (time, share): monotone cubics between [FritschButland1984], so equal shares are a
    /// hold; tau runs from the first time to the last. Throws `motion.keys` unless times increase
    /// and shares lie in [0, 1] and do not fall.
    static MotionLaw keyframes(PointsView rows);
    /// The time spent at a place is in proportion to a weight that is linear between the rows
    /// (share, weight). Throws `motion.weights` unless there are two or more, the shares increase
    /// from 0 to 1 and the weights are finite, not negative and not all 0.
    static MotionLaw weighted(PointsView rows);

    /// First `timing`, then this law in place of the time: weights along the way, walked with a
    /// timing of its own.
    MotionLaw after(const MotionLaw& timing) const;

    /// tau outside [0, 1] is taken to be 0 or 1.
    MotionState at(double tau) const;

private:
    struct Trusted {};
    MotionLaw(Function function, Trusted) : function_(std::move(function)) {}

    Function function_;
};

}  // namespace batten
