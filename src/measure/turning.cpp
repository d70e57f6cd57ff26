#include <cmath>
#include <numbers>

#include "batten/measure/curvature.hpp"
#include "measure/areas.hpp"
#include "measure/bezier/bend.hpp"
#include "measure/bends.hpp"
#include "shape/plane.hpp"

namespace batten {
namespace bezier {
namespace {

using bernstein::View;

/// A turning that misses -pi by less than this is half a turn, and that is to the left.
constexpr double half_turn_margin = 0x1p-30;

/// The angle from a to b in (-pi, pi].
double turn_between(plane::Vector a, plane::Vector b) {
    const double angle = std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
    return angle < -std::numbers::pi + half_turn_margin ? angle + 2 * std::numbers::pi : angle;
}

bool is_half_turn(double angle) {
    return std::fabs(angle) > std::numbers::pi - half_turn_margin;
}

plane::Vector direction_at_start(const Stretch& s) {
    return {s.coordinate(0).front(), s.coordinate(1).front()};
}
plane::Vector direction_at_end(const Stretch& s) {
    return {s.coordinate(0).back(), s.coordinate(1).back()};
}

/// How far the direction (x, y) turns over [0, 1]. If all coefficients lie in one half-plane the
/// direction stays in it, and the angle between the ends is the whole truth.
double turning_of(View x, View y, int halvings) {
    plane::Vector mean;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean.x += x[i];
        mean.y += y[i];
    }
    bool is_within_half_plane = true;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!(mean.x * x[i] + mean.y * y[i] > 0)) is_within_half_plane = false;
    }
    constexpr int most_halvings = 60;
    if (is_within_half_plane || halvings == most_halvings) {
        return turn_between({x.front(), y.front()}, {x.back(), y.back()});
    }
    const bernstein::Halves hx = bernstein::split(x, 0.5), hy = bernstein::split(y, 0.5);
    return turning_of(hx.left, hy.left, halvings + 1) +
           turning_of(hx.right, hy.right, halvings + 1);
}

/// The angles at which consecutive stretches meet, the seam of a closed curve last.
std::vector<double> corners(const Motion& motion) {
    std::vector<double> result;
    const std::vector<Stretch>& s = motion.stretches;
    for (std::size_t i = 0; i + 1 < s.size(); ++i) {
        result.push_back(turn_between(direction_at_end(s[i]), direction_at_start(s[i + 1])));
    }
    if (motion.pieces.curve().is_closed() && !s.empty()) {
        result.push_back(turn_between(direction_at_end(s.back()), direction_at_start(s[0])));
    }
    return result;
}

/// A stretch of the curve's parameter over which the curvature has one sign.
struct SignedPart {
    Interval t;
    int sign;
};

std::vector<SignedPart> signed_parts(const Motion& motion) {
    std::vector<SignedPart> parts;
    for (const Stretch& stretch : motion.stretches) {
        const Bend bend = bend_of(motion.pieces, stretch);
        const auto t_of = [&](double w) {
            return motion.pieces.t_of(stretch.piece, stretch.u_of(w));
        };
        for (const bernstein::SignRun& run : bernstein::sign_runs(bend.minors[0], bend.noise)) {
            const Interval t{t_of(run.where.lo), t_of(run.where.hi)};
            if (!parts.empty() && parts.back().sign == run.sign) {
                parts.back().t.hi = t.hi;
            } else {
                parts.push_back({t, run.sign});
            }
        }
    }
    return parts;
}

}  // namespace

double turning(const Motion& motion) {
    double sum = 0;
    for (const Stretch& stretch : motion.stretches) {
        sum += turning_of(stretch.coordinate(0), stretch.coordinate(1), 0);
    }
    for (const double angle : corners(motion)) sum += angle;
    return sum;
}

bool turns_back(const Motion& motion) {
    for (const double angle : corners(motion)) {
        if (is_half_turn(angle)) return true;
    }
    return false;
}

std::vector<double> inflections(const Motion& motion) {
    const std::vector<SignedPart> parts = signed_parts(motion);
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        result.push_back(Interval{parts[i].t.hi, parts[i + 1].t.lo}.middle());
    }
    if (!motion.pieces.curve().is_closed() || parts.empty() ||
        parts.front().sign == parts.back().sign) {
        return result;
    }
    // The straight stretch across the seam, from the last part to the first.
    const Interval domain = motion.pieces.curve().domain();
    const double before = domain.hi - parts.back().t.hi, after = parts.front().t.lo - domain.lo;
    if (after >= before) {
        result.insert(result.begin(), domain.lo + 0.5 * (after - before));
    } else {
        result.push_back(domain.hi - 0.5 * (before - after));
    }
    return result;
}

}  // namespace bezier

double turning(const Curve& curve) {
    bezier::require_dimension(curve, 2);
    return bezier::turning(bezier::Motion(curve));
}

std::vector<double> inflections(const Curve& curve) {
    bezier::require_dimension(curve, 2);
    return bezier::inflections(bezier::Motion(curve));
}

}  // namespace batten
