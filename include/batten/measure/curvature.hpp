#pragma once

#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

#include "batten/shape/curve.hpp"
#include "batten/shape/jet.hpp"

namespace batten {

/// Curvature from a jet of order 2 or more: in the plane signed, positive where the curve turns
/// left; elsewhere its magnitude. In 1 / data units. Nothing where the speed is zero or the
/// result beyond a double. A few ulps of |r''| / |r'|^2.
std::optional<double> curvature(const Jet& jet);

/// The sharpest place of a curve.
struct MaxCurvature {
    double value = 0;  ///< max |kappa|, in 1 / data units
    double t = 0;      ///< where; the first place if there are several
};

template <class Report, class Visit>
    requires std::same_as<std::remove_const_t<Report>, MaxCurvature>
void visit_fields(Report& r, Visit&& visit) {
    visit("value", r.value, "the largest curvature");
    visit("t", r.t, "parameter where it is");
}

/// The largest curvature, both sides of every break included; corners themselves do not count.
/// Nothing at a cusp, or where the curvature is infinite because the curve stops.
///
/// Aim:    polynomial pieces: the true maximum within 1e-14 of it, and none is missed, as all zeros
///         of the curvature's derivative are isolated; other curves: within 1e-10.
/// Laws:   points times 2^k give exactly 2^-k times the value at the same t.
/// Cost:   about 4 us a cubic in the plane.
/// Throws: `curve.not-finite`; `number.overflow`.
std::optional<MaxCurvature> max_curvature(const Curve& curve);

/// int kappa ds of a plane curve: how far its tangent turns in all, left positive, in radians.
/// Corners are included, also the seam of a closed curve and cusps, each within (-pi, pi]: an exact
/// turning back counts as half a turn to the left.
///
/// Laws:   simple closed curves: 2 pi or -2 pi. Reversal changes the sign, but for turnings back.
/// Throws: `curve.dimension` unless the curve is plane; `curve.not-finite`.
double turning(const Curve& curve);

/// The parameters at which the curvature of a plane curve changes its sign, rising; also across
/// breaks. Between two bends joined by a straight stretch: the middle of the stretch. Stretches
/// that turn by less than about 1e-14 radians are straight. A sign change at the seam of a closed
/// curve is listed at the start of the domain.
///
/// Throws: `curve.dimension` unless the curve is plane; `curve.not-finite`.
std::vector<double> inflections(const Curve& curve);

}  // namespace batten
