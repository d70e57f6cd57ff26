#include "batten/shape/arc_chain.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "shape/plane.hpp"

namespace batten {
namespace {

using plane::Vector;

using plane::array;
using plane::vector;

/// Cosine and sine of half the sweep, from bulge = tan(half / 2).
Vector half_turn(double bulge) {
    if (std::fabs(bulge) > 1) {  // so that the square of a huge bulge does not overflow
        const double inverse = 1 / bulge;
        const double scale = 1 / (1 + inverse * inverse);
        return {(inverse * inverse - 1) * scale, 2 * inverse * scale};
    }
    const double scale = 1 / (1 + bulge * bulge);
    return {(1 - bulge * bulge) * scale, 2 * bulge * scale};
}

/// One arc, prepared for walking along it.
struct Walk {
    Vector start, end, start_tangent, end_tangent;
    double curvature, length;

    explicit Walk(const Arc& arc)
        : start(vector(arc.start)),
          end(vector(arc.end)),
          start_tangent(vector(arc.start_tangent())),
          end_tangent(vector(arc.end_tangent())),
          curvature(arc.curvature()),
          length(arc.length()) {}
};

struct Step {
    Vector point, tangent;
};

/// From `start` along `tangent` for the arc length u, which may be negative.
Step step(Vector start, Vector tangent, double curvature, double u) {
    const double half = 0.5 * curvature * u;
    const double c = std::cos(half), s = std::sin(half);
    const double chord = half == 0 ? u : u * (s / half);
    const Vector along = plane::turned(tangent, c, s);
    return {start + chord * along, plane::turned(along, c, s)};
}

}  // namespace

double Arc::sweep() const { return 4 * std::atan(bulge); }

double Arc::curvature() const {
    return 2 * half_turn(bulge).y / plane::norm(vector(end) - vector(start));
}

double Arc::length() const {
    const double chord = plane::norm(vector(end) - vector(start));
    return is_line() ? chord : chord * (2 * std::atan(bulge) / half_turn(bulge).y);
}

std::optional<double> Arc::radius() const {
    if (is_line()) return std::nullopt;
    const double chord = plane::norm(vector(end) - vector(start));
    return 0.5 * chord / std::fabs(half_turn(bulge).y);
}

std::optional<std::array<double, 2>> Arc::center() const {
    if (is_line()) return std::nullopt;
    const Vector half_chord = 0.5 * (vector(end) - vector(start));
    const Vector half = half_turn(bulge);
    return array(vector(start) + half_chord + (half.x / half.y) * plane::left_of(half_chord));
}

std::array<double, 2> Arc::start_tangent() const {
    const Vector half = half_turn(bulge);
    return array(plane::turned(plane::unit(vector(end) - vector(start)), half.x, -half.y));
}

std::array<double, 2> Arc::end_tangent() const {
    const Vector half = half_turn(bulge);
    return array(plane::turned(plane::unit(vector(end) - vector(start)), half.x, half.y));
}

ArcChain::ArcChain(Points joints, std::vector<double> bulges, bool closed)
    : joints_(std::move(joints)), bulges_(std::move(bulges)), closed_(closed) {
    require_dimension(joints_, 2, 2);
    require_count(joints_, 2);
    require_finite(joints_);
    require_distinct(joints_, false);
    const std::size_t n = bulges_.size();
    if (n + 1 != joints_.size()) {
        throw Error("curve.arcs", "bulges", std::to_string(n), "one bulge an arc is needed");
    }
    const auto joint = [&](std::size_t i) { return std::as_const(joints_)[i]; };
    if (closed && !std::equal(joint(0).begin(), joint(0).end(), joint(n).begin())) {
        throw Error("curve.arcs", "joint " + std::to_string(n), format_number(joints_(n, 0)),
                    "a closed chain must end where it starts");
    }
    breaks_.assign(1, 0.0);
    breaks_.reserve(n + 1);
    for (std::size_t i = 0; i < n; ++i) {
        const double next = breaks_[i] + arc(i).length();
        const double radius = arc(i).radius().value_or(0);
        if (!(next > breaks_[i]) || !std::isfinite(next) || !std::isfinite(radius)) {
            throw Error("curve.arcs", "arc " + std::to_string(i),
                        "bulge " + format_number(bulges_[i]),
                        "every arc needs a finite radius, and a length that is not lost beside the "
                        "others'");
        }
        breaks_.push_back(next);
    }
}

Arc ArcChain::arc(std::size_t i) const {
    return {{joints_(i, 0), joints_(i, 1)}, {joints_(i + 1, 0), joints_(i + 1, 1)}, bulges_[i]};
}

std::optional<int> ArcChain::degree() const {
    const bool straight =
        std::all_of(bulges_.begin(), bulges_.end(), [](double bulge) { return bulge == 0; });
    return straight ? std::optional<int>(1) : std::nullopt;
}

void ArcChain::jets_on(std::size_t piece, std::span<const double> t, int order,
                       std::span<double> out) const {
    const Walk walk(arc(piece));
    const std::size_t width = 2 * static_cast<std::size_t>(order + 1);
    for (std::size_t i = 0; i < t.size(); ++i) {
        const double from_start = t[i] - breaks_[piece];
        const double from_end = t[i] - breaks_[piece + 1];
        // From the nearer end: so both joints are met exactly.
        const Step here = from_start < -from_end
                              ? step(walk.start, walk.start_tangent, walk.curvature, from_start)
                              : step(walk.end, walk.end_tangent, walk.curvature, from_end);
        double* const row = out.data() + i * width;
        row[0] = here.point.x;
        row[1] = here.point.y;
        Vector derivative = here.tangent;
        for (std::size_t d = 1; d <= static_cast<std::size_t>(order); ++d) {
            row[2 * d] = derivative.x;
            row[2 * d + 1] = derivative.y;
            derivative = walk.curvature * plane::left_of(derivative);
        }
    }
}

}  // namespace batten
