#pragma once

#include <concepts>
#include <span>
#include <type_traits>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// The point of a curve that is nearest to a given one.
struct Nearest {
    double t = 0;
    std::vector<double> point;
    double distance = 0;
    /// In the plane: 1 if the given point lies to the left of the curve, -1 to the right, 0 on it
    /// or straight ahead of an end. At a corner both pieces are asked. In other dimensions 0.
    int side = 0;
};

template <class Report, class Visit>
    requires std::same_as<std::remove_const_t<Report>, Nearest>
void visit_fields(Report& r, Visit&& visit) {
    visit("t", r.t, "parameter of the nearest point");
    visit("point", r.point, "the nearest point");
    visit("distance", r.distance, "how far it is");
    visit("side", r.side, "1 where the given point lies to the left of the curve, -1 to the right");
}

/// The nearest point of all: no nearer one exists, however the curve winds. Several equally near
/// ones: one of them, always the same.
///
/// Aim:    distance within 1e-14 of the extent (other than polynomial curves: 1e-13). Where the
///         curve is nearly a circle around the point, t is only known as well as the distance lets
///         it be.
/// Laws:   points times 2^k give exactly the same t and 2^k times the distance.
/// Cost:   about 1 us a piece once, then about 5 us a point.
/// Throws: `points.dimension` unless the point has as many coordinates as the curve,
///         `points.not-finite`; `curve.not-finite`; `number.overflow`.
/// Source: pieces are visited in the order of the distance of their boxes; in each all zeros of
///         (r - p).r' are isolated [Farouki2012].
Nearest nearest(const Curve& curve, std::span<const double> point);

/// The same for many points, with one set-up.
std::vector<Nearest> nearest(const Curve& curve, PointsView points);

}  // namespace batten
