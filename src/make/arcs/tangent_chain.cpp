#include "make/arcs/tangent_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace batten::arc_spline {
namespace {

using plane::Vector;

/// The chain for one start tangent, seen as a function of how far that tangent is turned.
struct Swing {
    double cc = 0, cs = 0, ss = 0;  ///< the quadratic form of the curvature differences
    double first_a = 0, first_b = 0, last_a = 0, last_b = 0;
    double forward_cosine = 0, forward_sine = 0;

    void add_difference(double a, double b) {
        cc += a * a;
        cs += a * b;
        ss += b * b;
    }
};

/// Walks along the chain that starts along `tangent`. With that start turned by x, tangent k turns
/// by x or, k odd, by -x.
Swing swing(PointsView points, Vector tangent) {
    Swing sums;
    double sign = 1;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const Vector d = plane::at(points, k + 1) - plane::at(points, k);
        const double chord = plane::norm(d);
        const Vector u = (1 / chord) * d;
        const double c = plane::cross(tangent, u), e = plane::dot(tangent, u);
        const double a = 2 * c / chord, b = -sign * 2 * e / chord;
        if (k == 0) {
            sums.first_a = a;
            sums.first_b = b;
        } else {
            sums.add_difference(a - sums.last_a, b - sums.last_b);
        }
        sums.last_a = a;
        sums.last_b = b;
        sums.forward_cosine += e;
        sums.forward_sine += sign * c;
        tangent = plane::unit(2 * e * u - tangent);
        sign = -sign;
    }
    return sums;
}

Vector first_chord(PointsView points) {
    return plane::unit(plane::at(points, 1) - plane::at(points, 0));
}

/// `start` turned by x or by x + pi, whichever runs along the chords rather than against them.
Vector forward(Vector start, double x, const Swing& sums) {
    const Vector turn = plane::direction(x);
    const double along = sums.forward_cosine * turn.x + sums.forward_sine * turn.y;
    const Vector tangent = plane::turned(start, turn.x, turn.y);
    return along < 0 ? -tangent : tangent;
}

}  // namespace

Vector tangent_chain(PointsView points, Vector tangent, std::span<double> bulges) {
    // Reflections keep the length 1 up to an ulp each: renewed now and then, off the critical path.
    constexpr std::size_t steps_between_renewals = 64;
    const double* p = points.coordinates().data();
    for (std::size_t k = 0; k < bulges.size(); ++k, p += 2) {
        const double dx = p[2] - p[0], dy = p[3] - p[1];
        const double per_chord = 1 / std::sqrt(dx * dx + dy * dy);
        const Vector u{per_chord * dx, per_chord * dy};
        const double c = plane::cross(tangent, u), e = plane::dot(tangent, u);
        bulges[k] = e >= 0 ? c / (1 + e) : (1 - e) / c;
        tangent = 2 * e * u - tangent;
        if (k % steps_between_renewals == 0) tangent = plane::unit(tangent);
    }
    return tangent;
}

Vector smoothest_start(PointsView points, bool closed) {
    const Vector start = first_chord(points);
    Swing sums = swing(points, start);
    if (closed) sums.add_difference(sums.first_a - sums.last_a, sums.first_b - sums.last_b);
    const double difference = 0.5 * (sums.ss - sums.cc);
    if (difference == 0 && sums.cs == 0) return start;
    return forward(start, 0.5 * std::atan2(-sums.cs, difference), sums);
}

std::optional<Vector> closing_start(PointsView ring) {
    constexpr double closed_angle = 1e-9;  // radians: below what any use of the arcs can see
    const std::size_t chords = ring.size() - 1;
    std::vector<double> bulges(chords);
    const auto steepest_from = [&](Vector tangent) {
        tangent_chain(ring, tangent, bulges);
        return steepest(bulges);
    };
    const Vector start = first_chord(ring);
    const double turn = plane::angle_between(start, tangent_chain(ring, start, bulges));
    Vector tangent;
    if (chords % 2 == 1) {
        const Vector half = plane::direction(0.5 * turn);
        tangent = plane::turned(start, half.x, half.y);
        if (steepest_from(-tangent) < steepest_from(tangent)) tangent = -tangent;
    } else if (std::fabs(turn) <= closed_angle) {
        tangent = smoothest_start(ring, true);
    } else {
        return std::nullopt;
    }
    return steepest_from(tangent) <= 1 ? std::optional(tangent) : std::nullopt;
}

double steepest(std::span<const double> bulges) {
    double most = 0;
    for (const double bulge : bulges) most = std::max(most, std::fabs(bulge));
    return most;
}

}  // namespace batten::arc_spline
