#include "make/pseudo/three_point.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "batten/base/interval.hpp"
#include "make/pseudo/free_end.hpp"
#include "make/pseudo/segment/angles.hpp"

namespace batten::pseudo {
namespace {

constexpr double pi = std::numbers::pi;

/// The angles to both chords, u + v = total, both in [0, pi]; w = J(u) + weight J(v).
struct Balance {
    double u = 0;
    double energy = 0;
    bool is_converged = true;
};

/// What is balanced: J(u) + weight J(total - u) over `range`.
struct Scales {
    double total, weight;
    Interval range;
};

/// Both free ends at u, each on a minimum of its own.
struct Pair {
    FreeEnd first, second;

    double energy(const Scales& s) const {
        return first.pseudo_energy + s.weight * second.pseudo_energy;
    }
    double slope(const Scales& s) const { return first.slope - s.weight * second.slope; }
    double curvature(const Scales& s) const {
        return first.curvature + s.weight * second.curvature;
    }
};

/// The minimum of w along one pair of minima: Newton in a shrinking bracket. Nothing if w falls
/// right to the end of the range.
std::optional<Balance> follow(const Scales& scales, double start, Pair pair) {
    constexpr int most_steps = 80;
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    Interval bracket = scales.range;
    double u = start;
    double step_before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most_steps; ++k) {
        const double slope = pair.slope(scales);
        (slope > 0 ? bracket.hi : bracket.lo) = u;
        const double newton = -slope / pair.curvature(scales);
        const bool is_newton = pair.curvature(scales) > 0 && bracket.contains(u + newton);
        const double step = is_newton ? newton : bracket.middle() - u;
        const bool has_stalled = std::fabs(step) >= 0.5 * step_before;
        const double close = 1e-9 * scales.total;
        if (std::fabs(step) <= epsilon * u || (std::fabs(step) < close && has_stalled)) {
            if (std::fabs(newton) > close) return std::nullopt;  // at an end of the range
            return Balance{u, pair.energy(scales),
                           pair.first.is_converged && pair.second.is_converged};
        }
        step_before = std::fabs(step);
        u += step;
        pair = {free_end_near(u, pair.first.segment),
                free_end_near(scales.total - u, pair.second.segment)};
    }
    return Balance{u, pair.energy(scales), false};
}

/// The least minimum over all pairs of free-end minima near u, if w has one there.
std::optional<Balance> least_near(const Scales& scales, double u) {
    std::optional<Balance> least;
    for (const FreeEnd& first : free_end_minima(u)) {
        for (const FreeEnd& second : free_end_minima(scales.total - u)) {
            const auto found = follow(scales, u, {first, second});
            if (found && (!least || found->energy < least->energy)) least = found;
        }
    }
    return least;
}

/// The least w between the two chords (total = turn) or outside them (total = 2 pi - turn).
std::optional<Balance> balance(double total, double weight) {
    if (total >= 2 * pi) return std::nullopt;
    if (weight == 1) {
        const FreeEnd end = free_end(total / 2);
        return Balance{total / 2, 2 * end.pseudo_energy, end.is_converged};
    }
    const Scales scales{total, weight, {std::fmax(0, total - pi), std::fmin(total, pi)}};
    const double guess = total * weight / (1 + weight);  // exact where J = 3 theta^2
    std::optional<Balance> least = least_near(scales, scales.range.clamp(guess));
    for (int round = 0; least && round < 3; ++round) {
        const auto again = least_near(scales, least->u);
        if (!again || !(again->energy < least->energy * (1 - 1e-14))) break;
        least = again;
    }
    return least;
}

/// The rule's symmetries taken out: a left turn, the longer chord first.
struct Normalised {
    Normalised(const ThreePoints& points, double weight_exponent);

    /// The tangent found at `u` from the longer chord, `total` being shared by the chords.
    ThreePointAngle back(const Balance& balance, double total) const;

    double turn;
    double side;
    double weight;  // of the shorter chord, the longer one's being 1
    double unit;
    bool is_first_longer;
};

Normalised::Normalised(const ThreePoints& points, double weight_exponent)
    : turn(wrap(points.turn)),
      side(std::copysign(1.0, turn)),
      is_first_longer(points.length0 >= points.length1) {
    const double longer = is_first_longer ? points.length0 : points.length1;
    const double shorter = is_first_longer ? points.length1 : points.length0;
    weight = relative_weight(shorter / longer, weight_exponent);
    unit = std::pow(longer, weight_exponent);
    turn = std::fabs(turn);
}

ThreePointAngle Normalised::back(const Balance& balance, double total) const {
    const double u = is_first_longer ? balance.u : total - balance.u;
    return {side * u, unit * balance.energy, balance.is_converged};
}

}  // namespace

double relative_weight(double ratio, double weight_exponent) {
    return Interval{1e-60, 1e60}.clamp(std::pow(ratio, weight_exponent));
}

ThreePointAngle three_point_angle(const ThreePoints& points, double weight_exponent) {
    const Normalised rule(points, weight_exponent);
    if (rule.turn == 0) return {};
    const auto inner = balance(rule.turn, rule.weight);
    assert(inner);  // w falls at one end of [0, turn] and rises at the other
    return rule.back(*inner, rule.turn);
}

std::optional<ThreePointAngle> three_point_rival(const ThreePoints& points,
                                                 double weight_exponent) {
    const Normalised rule(points, weight_exponent);
    const double total = 2 * pi - rule.turn;
    const auto outer = balance(total, rule.weight);
    if (!outer) return std::nullopt;
    ThreePointAngle rival = rule.back(*outer, total);
    rival.angle = wrap(-rival.angle);
    return rival;
}

}  // namespace batten::pseudo
