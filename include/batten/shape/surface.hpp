#pragma once

#include <span>
#include <variant>

#include "batten/shape/curved_knot_surface.hpp"
#include "batten/shape/spline_surface.hpp"

namespace batten {

/// Any spline surface z = S(x, y).
using Surface = std::variant<SplineSurface, CurvedKnotSurface>;

Rectangle domain_of(const Surface& surface);

/// The height, or a derivative. Throws `surface.derivative` for derivatives where knot lines are
/// curved.
double height_at(const Surface& surface, double x, double y, Partial derivative = {});

/// The same on a grid, x.size() x y.size(), x and y rising.
Grid heights_on(const Surface& surface, std::span<const double> x, std::span<const double> y,
                Partial derivative = {});

}  // namespace batten
