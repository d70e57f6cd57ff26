#include <cmath>
#include <complex>

#include "batten/make/log_aesthetic.hpp"
#include "num/roots.hpp"
#include "shape/log_aesthetic/profile.hpp"

namespace batten {
namespace {

using spiral::Profile;

constexpr double growth = 1.8;  ///< of the bracket, from 0 outwards

double chord_angle_of(double alpha, double log_ratio, double turn) {
    return std::arg(Profile::by_ratio(alpha, log_ratio, turn).end());
}

/// The interval of r that holds the root, or nothing where it lies beyond what can be told from
/// the limit in double.
std::optional<Interval> bracket_of(double alpha, double turn, double wanted) {
    const double sign = wanted > 0.5 * turn ? 1 : -1;
    const double most = spiral::largest_exponent / (std::fabs(alpha) + 1);
    // The chord of a nearly circular arc stands at turn (1 / 2 + r / 12).
    double near = 0, far = sign * std::fmax(1e-8, std::fabs(1.1 * (12 * wanted / turn - 6)));
    while (sign * (chord_angle_of(alpha, far, turn) - wanted) < 0) {
        near = far;
        far *= growth;
        if (std::fabs(far) > most) return std::nullopt;
    }
    return Interval{std::fmin(near, far), std::fmax(near, far)};
}

/// The arc of positive turn over the unit chord.
std::optional<LogAestheticSegment> left_segment(double alpha, double chord_angle, double turn) {
    const double most = largest_chord_angle(alpha, turn);
    if (!(turn - most < chord_angle && chord_angle < most)) return std::nullopt;
    const std::optional<Interval> bracket = bracket_of(alpha, turn, chord_angle);
    if (!bracket) return std::nullopt;
    const double r = num::find_root(
                         [&](double at) { return chord_angle_of(alpha, at, turn) - chord_angle; },
                         *bracket, 1e-16)
                         .at;
    const Profile profile = Profile::by_ratio(alpha, r, turn);
    const double length = 1 / std::abs(profile.end());
    return LogAestheticSegment{alpha, length, profile.curvature(0) / length,
                               profile.curvature(1) / length};
}

}  // namespace

double largest_chord_angle(double alpha, double turn) {
    if (0 <= alpha && alpha <= 1) return turn;
    const double p = (alpha - 1) / alpha;
    std::complex<double> sum = 0, term = 1;
    for (int k = 0; std::abs(term) > 1e-18; ++k) {
        sum += term / (k * p + 1);
        term *= std::complex<double>(0, turn / (k + 1));
    }
    return alpha > 1 ? std::arg(sum) : turn - std::arg(sum);
}

std::optional<LogAestheticSegment> log_aesthetic_segment(double alpha, double chord,
                                                         double chord_angle, double turn) {
    const double sign = turn < 0 ? -1 : 1;
    std::optional<LogAestheticSegment> unit = left_segment(alpha, sign * chord_angle, sign * turn);
    if (!unit) return unit;
    unit->length *= chord;
    unit->start_curvature *= sign / chord;
    unit->end_curvature *= sign / chord;
    return unit;
}

}  // namespace batten
