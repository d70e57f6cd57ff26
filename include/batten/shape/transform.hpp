#pragma once

#include <optional>

#include "batten/shape/curve.hpp"
#include "batten/shape/piecewise_cubic.hpp"

namespace batten {

/// The same points in the opposite direction, over the same domain: t becomes lo + hi - t.
Curve reversed(const Curve& curve);

/// All coordinates times `factor`. Throws `curve.scale` unless it is finite and not 0.
Curve scaled(const Curve& curve, double factor);

/// `curve` as cubic pieces over the same breaks, if all its pieces are polynomials of degree 3 or
/// less: the Taylor coefficients at each piece's start, so exact to rounding.
std::optional<PiecewiseCubic> exact_cubic(const Curve& curve);

/// The points at the breaks of `curve` (closed: the first again at the end), if all its pieces are
/// straight and run at constant speed: of degree 1, or cubics whose higher coefficients are 0.
std::optional<Points> exact_polyline(const Curve& curve);

}  // namespace batten
