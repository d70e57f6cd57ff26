#include "make/pseudo/local_angles.hpp"

#include <cmath>
#include <optional>

#include "make/pseudo/free_end.hpp"
#include "make/pseudo/segment/angles.hpp"
#include "make/pseudo/tables/ends.hpp"
#include "make/pseudo/three_point.hpp"
#include "num/plane_angles.hpp"

namespace batten::pseudo {
namespace {

struct Chord {
    double x, y;
};

Chord chord_between(PointsView points, std::size_t from, std::size_t to) {
    return {points(to, 0) - points(from, 0), points(to, 1) - points(from, 1)};
}

/// sqrt(x^2 + y^2) with scaling by powers of two alone, so that it commutes with them.
double length_of(const Chord& c) {
    int exponent = 0;
    std::frexp(std::fmax(std::fabs(c.x), std::fabs(c.y)), &exponent);
    const double x = std::ldexp(c.x, -exponent);
    const double y = std::ldexp(c.y, -exponent);
    return std::ldexp(std::sqrt(x * x + y * y), exponent);
}

/// The angle from a to b in (-pi, pi]; exactly 0 or pi for parallel chords.
double turn_between(const Chord& a, const Chord& b) {
    const double la = length_of(a);
    const double lb = length_of(b);
    const Chord u{a.x / la, a.y / la};
    const Chord v{b.x / lb, b.y / lb};
    return num::angle_of(u.x * v.x + u.y * v.y, u.x * v.y - u.y * v.x);
}

/// The tangents at one point, from the chord before and from the chord after it; nothing where an
/// end is free.
struct Joint {
    std::optional<double> before, after;
};

/// The spans before and after every point, and what is known of their tangents.
class Joints {
public:
    Joints(PointsView points, const AngleRules& rules)
        : points_(points), rules_(rules), spans_(chords(points, rules)), joints_(points.size()) {}

    std::vector<SpanAngles> solve();

private:
    bool is_inner(std::size_t i) const {
        return rules_.is_closed || (i > 0 && i + 1 < joints_.size());
    }
    const SpanAngles& span_before(std::size_t i) const {
        return spans_[(i + spans_.size() - 1) % spans_.size()];
    }
    void put_rule(std::size_t i);
    void put_fixed(const FixedTangent& tangent);
    double free_angle(double other) const {
        return rules_.source == Source::tables ? tabulated_end(other).theta1
                                               : free_end(other).segment.theta1;
    }

    PointsView points_;
    const AngleRules& rules_;
    std::vector<SpanAngles> spans_;
    std::vector<Joint> joints_;
};

void Joints::put_rule(std::size_t i) {
    const std::size_t n = points_.size();
    const std::size_t before = (i + n - 1) % n;
    const std::size_t after = (i + 1) % n;
    const double turn =
        turn_between(chord_between(points_, before, i), chord_between(points_, i, after));
    const ThreePoints three{turn, span_before(i).length, spans_[i].length};
    const double angle =
        rules_.source == Source::tables
            ? tabulated_three_point_angle(three, rules_.weight_exponent)
            : three_point_angle(three, rules_.weight_exponent).angle;
    joints_[i] = {angle, wrap(angle - turn)};
}

void Joints::put_fixed(const FixedTangent& tangent) {
    const std::size_t i = static_cast<std::size_t>(tangent.index);
    const double psi = tangent.angle.radians;
    const bool has_span_before = rules_.is_closed || i > 0;
    const bool has_span_after = rules_.is_closed || i + 1 < joints_.size();
    if (has_span_before) joints_[i].before = wrap(psi - span_before(i).direction);
    if (has_span_after) joints_[i].after = wrap(psi - spans_[i].direction);
}

std::vector<SpanAngles> Joints::solve() {
    std::vector<bool> has_rule(joints_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i) has_rule[i] = is_inner(i);
    for (int corner : rules_.corners) has_rule[static_cast<std::size_t>(corner)] = false;
    for (const FixedTangent& tangent : rules_.tangents) {
        has_rule[static_cast<std::size_t>(tangent.index)] = false;
    }
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (has_rule[i]) put_rule(i);
        rules_.progress.at(i + 1, joints_.size());
    }
    for (const FixedTangent& tangent : rules_.tangents) put_fixed(tangent);
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        const std::optional<double> start = joints_[i].after;
        const std::optional<double> end = joints_[(i + 1) % joints_.size()].before;
        if (start || end) {
            spans_[i].theta0 = start ? *start : free_angle(*end);
            spans_[i].theta1 = end ? *end : free_angle(*start);
        }
    }
    return spans_;
}

}  // namespace

std::vector<SpanAngles> chords(PointsView points, const AngleRules& rules) {
    const std::size_t n = points.size();
    std::vector<SpanAngles> spans(rules.is_closed ? n : n - 1);
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const Chord chord = chord_between(points, i, (i + 1) % n);
        spans[i].length = length_of(chord);
        spans[i].direction = std::atan2(chord.y, chord.x);
    }
    return spans;
}

std::vector<SpanAngles> local_angles(PointsView points, const AngleRules& rules) {
    return Joints(points, rules).solve();
}

}  // namespace batten::pseudo
