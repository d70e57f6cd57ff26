#include "make/arcs/biarc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace batten::arc_spline {
namespace {

using plane::Vector;

using plane::array;
using plane::vector;

/// tan(angle / 2), `angle` from unit vector a to unit vector b.
double half_tangent(Vector a, Vector b) {
    const double c = plane::cross(a, b), e = plane::dot(a, b);
    return e >= 0 ? c / (1 + e) : (1 - e) / c;
}

/// The arc that leaves `from` and ends at `end`, if there is one.
std::optional<Arc> arc_to(const Station& from, Vector end) {
    const Vector chord = end - from.point;
    if (chord == Vector{}) return std::nullopt;
    const double bulge = half_tangent(from.tangent, plane::unit(chord));
    if (!std::isfinite(bulge)) return std::nullopt;
    return Arc{array(from.point), array(end), bulge};
}

std::optional<double> tangent_length(const Station& from, const Station& to) {
    const Vector v = to.point - from.point;
    const Vector spread = from.tangent - to.tangent;
    const double ahead = plane::dot(v, from.tangent + to.tangent);
    const double turn = plane::dot(spread, spread);  // 2 (1 - T0.T1)
    const double chord_sq = plane::dot(v, v);
    const double root = std::sqrt(ahead * ahead + turn * chord_sq);
    const double d = ahead > 0 ? chord_sq / (ahead + root) : (root - ahead) / turn;
    return std::isfinite(d) ? std::optional(d) : std::nullopt;
}

/// Half of the sweep of the one arc that nearly meets both tangents, where there is one and it is
/// no more than half a circle.
std::optional<double> single_half_sweep(const Station& from, const Station& to) {
    constexpr double same_angle = 1e-9;
    constexpr double most = 0.5 * std::numbers::pi + same_angle;
    const Vector u = plane::unit(to.point - from.point);
    // Sines differ by less than their angles do: so most pairs need no angle.
    const double apart = plane::cross(from.tangent, u) - plane::cross(u, to.tangent);
    if (std::fabs(apart) > 2 * same_angle) return std::nullopt;
    const double in = plane::angle_between(from.tangent, u);
    const double out = plane::angle_between(u, to.tangent);
    if (std::fabs(in - out) > same_angle || std::fabs(in) > most) return std::nullopt;
    return 0.5 * (in + out);
}

}  // namespace

Arc straightened(Arc arc, double max_radius) {
    constexpr double straight_bulge = 0x1p-39;  // the sagitta is chord x bulge / 2
    const bool is_large = std::isfinite(max_radius) && arc.radius().value_or(0) > max_radius;
    if (std::fabs(arc.bulge) <= straight_bulge || is_large) arc.bulge = 0;
    return arc;
}

std::optional<Moves> biarc(const Station& from, const Station& to) {
    if (from.point == to.point) return std::nullopt;
    if (const std::optional<double> half = single_half_sweep(from, to)) {
        return Moves{{Arc{array(from.point), array(to.point), std::tan(0.5 * *half)}}, 1};
    }
    const std::optional<double> d = tangent_length(from, to);
    if (!d) return std::nullopt;
    const Vector joint =
        0.5 * (from.point + to.point + *d * (from.tangent - to.tangent));
    const std::optional<Arc> first = arc_to(from, joint);
    // The second arc seen from its end: so it meets the end's tangent exactly.
    const std::optional<Arc> second = arc_to({to.point, -to.tangent}, joint);
    if (!first || !second) return std::nullopt;
    return Moves{{*first, Arc{array(joint), array(to.point), -second->bulge}}, 2};
}

ArcRuler::ArcRuler(const Arc& arc)
    : start_(vector(arc.start)),
      end_(vector(arc.end)),
      tangent_(vector(arc.start_tangent())),
      normal_(plane::left_of(tangent_)),
      curvature_(arc.curvature()),
      length_(arc.length()) {}

Foot ArcRuler::foot(Vector p) const {
    const Vector w = p - start_;
    const double ahead = plane::dot(w, tangent_), aside = plane::dot(w, normal_);
    double along = ahead;
    if (curvature_ != 0) {
        along = std::atan2(curvature_ * ahead, 1 - curvature_ * aside) / curvature_;
        // Behind the start it may be before the end, where the arc is more than half a circle.
        const double round = 2 * std::numbers::pi / std::fabs(curvature_);
        if (along < 0 && along + round <= length_) along += round;
    }
    if (along >= 0 && along <= length_) {
        // (|p - C| - R) without the centre, for any curvature.
        const double q = curvature_ * plane::dot(w, w) - 2 * aside;
        const double root = std::sqrt(std::max(0.0, 1 + curvature_ * q));
        return {std::fabs(q / (1 + root)), along};
    }
    const double to_start = plane::norm(w), to_end = plane::norm(p - end_);
    return to_start <= to_end ? Foot{to_start, 0} : Foot{to_end, length_};
}

RowRuler::RowRuler(const Moves& moves) {
    for (int i = 0; i < moves.count; ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        rulers_[k].emplace(moves.arcs[k]);
        length_ += rulers_[k]->length();
    }
}

RowFoot RowRuler::foot(Vector p) const {
    RowFoot nearest{rulers_[0]->foot(p), 0};
    if (rulers_[1]) {
        Foot second = rulers_[1]->foot(p);
        second.along += rulers_[0]->length();
        if (second.distance < nearest.foot.distance) nearest = {second, 1};
    }
    return nearest;
}

}  // namespace batten::arc_spline
