#include "make/arcs/tangents.hpp"

#include <optional>

namespace batten::arc_spline {
namespace {

using plane::Vector;

/// The circle's tangent at its first point, by reflection of the one at the second.
Vector end_tangent(Vector here, Vector next, Vector last) {
    if (here == next) return plane::unit(last - here);
    const Vector u = plane::unit(next - here);
    const Vector t = circle_tangent(here, next, last);
    return 2 * plane::dot(t, u) * u - t;
}

/// The tangent at point i of the circle through neighbours `reach` away, if there are such.
std::optional<Vector> proposal(PointsView points, std::size_t i, std::size_t reach, bool closed) {
    const std::size_t n = points.size();
    const auto at = [&](std::size_t k) { return plane::at(points, k % n); };
    if (closed) {
        if (2 * reach + 1 > n) return std::nullopt;
        return circle_tangent(at(i + n - reach), at(i), at(i + reach));
    }
    if (n == 2) return plane::unit(at(1) - at(0));
    if (2 * reach + 1 > n) return std::nullopt;
    if (i < reach) {
        if (i > 0) return std::nullopt;
        return end_tangent(at(0), at(reach), at(2 * reach));
    }
    if (i + reach >= n) {
        if (i + 1 < n) return std::nullopt;
        return -end_tangent(at(i), at(i - reach), at(i - 2 * reach));
    }
    return circle_tangent(at(i - reach), at(i), at(i + reach));
}

}  // namespace

Vector circle_tangent(Vector before, Vector here, Vector after) {
    const Vector in = here - before, out = after - here;
    if (out == Vector{}) return plane::unit(in);
    if (in == Vector{}) return plane::unit(out);
    const double l = plane::norm(in), m = plane::norm(out);
    const Vector sum = (m / l) * in + (l / m) * out;
    return sum == Vector{} ? plane::left_of(plane::unit(in)) : plane::unit(sum);
}

Tangents::Tangents(PointsView points, std::span<const std::size_t> reaches, bool closed,
                   const std::vector<FixedTangent>& given) {
    std::vector<std::optional<Vector>> fixed(points.size());
    for (const FixedTangent& tangent : given) {
        fixed[static_cast<std::size_t>(tangent.index)] = plane::direction(tangent.angle.radians);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        first_.push_back(all_.size());
        if (fixed[i]) {
            all_.push_back(*fixed[i]);
            continue;
        }
        for (const std::size_t reach : reaches) {
            if (const auto tangent = proposal(points, i, reach, closed)) all_.push_back(*tangent);
        }
    }
    first_.push_back(all_.size());
}

}  // namespace batten::arc_spline
