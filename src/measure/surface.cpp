#include "batten/measure/surface.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "shape/space.hpp"

namespace batten {
namespace {

using space::cross;
using space::dot;
using space::Vector;

Vector scaled(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
Vector unit(const Vector& a) { return scaled(1 / std::sqrt(dot(a, a)), a); }

/// Two directions across the axis, and across one another: from the coordinate axis furthest away.
struct Across {
    Vector first, second;
};

Across across(const Vector& axis) {
    const Vector d = unit(axis);
    std::size_t far = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (std::fabs(d[k]) < std::fabs(d[far])) far = k;
    }
    Vector a = scaled(-d[far], d);
    a[far] += 1;
    a = unit(a);
    return {a, cross(d, a)};
}

}  // namespace

std::optional<SurfaceBend> surface_bend(const SurfaceJet& jet) {
    const Vector normal = cross(jet.u, jet.v);
    const double size_sq = dot(normal, normal);
    if (!(size_sq > 0)) return std::nullopt;
    SurfaceBend bend{unit(normal), 0, 0};
    const double e = dot(bend.normal, jet.uu), f = dot(bend.normal, jet.uv),
                 g = dot(bend.normal, jet.vv);
    const double ee = dot(jet.u, jet.u), ff = dot(jet.u, jet.v), gg = dot(jet.v, jet.v);
    bend.gaussian = (e * g - f * f) / size_sq;
    bend.mean = (e * gg - 2 * f * ff + g * ee) / (2 * size_sq);
    if (!std::isfinite(bend.gaussian) || !std::isfinite(bend.mean)) return std::nullopt;
    return bend;
}

std::optional<double> zebra_angle(const SurfaceJet& jet, const ZebraView& view) {
    const auto bend = surface_bend(jet);
    if (!bend) return std::nullopt;
    Vector ray = jet.point;
    for (std::size_t k = 0; k < 3; ++k) ray[k] -= view.eye[k];
    ray = unit(ray);
    const double twice = 2 * dot(ray, bend->normal);
    for (std::size_t k = 0; k < 3; ++k) ray[k] -= twice * bend->normal[k];
    const auto [first, second] = across(view.axis);
    const double angle = std::atan2(dot(ray, second), dot(ray, first));
    return std::isfinite(angle) ? std::optional(angle) : std::nullopt;
}

bool is_dark(double angle, int stripes) {
    return std::fmod(std::floor(angle * stripes / std::numbers::pi), 2) != 0;
}

Interval gaussian_range(const CoonsPatch& patch, int count) {
    Interval range{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            const auto bend = surface_bend(patch.jet(double(i) / (count - 1), double(j) / (count - 1)));
            if (!bend) continue;
            range = {std::fmin(range.lo, bend->gaussian), std::fmax(range.hi, bend->gaussian)};
        }
    }
    return range.lo <= range.hi ? range : Interval{0, 0};
}

}  // namespace batten
