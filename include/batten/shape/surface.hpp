#pragma once

#include <span>
#include <variant>

#include "batten/shape/curved_knot_surface.hpp"
#include "batten/shape/spline_surface.hpp"

namespace batten {

/// Any spline surface z = S(x, y).
using Surface = std::variant<SplineSurface, CurvedKnotSurface>;

Rectangle domain_of(const Surface& surface);

/// The height, or a derivative. Throws what CurvedKnotSurface throws.
double height_at(const Surface& surface, double x, double y, Partial derivative = {});

/// The height, its first and its second derivatives.
HeightJet jet_at(const Surface& surface, double x, double y);

/// The same on a grid, x.size() x y.size(), x and y rising.
Grid heights_on(const Surface& surface, std::span<const double> x, std::span<const double> y,
                Partial derivative = {});

/// As for the surface it is.
double integral(const Surface& surface, const Rectangle& part);
SplineFunction section_at_y(const Surface& surface, double y);
SplineFunction section_at_x(const Surface& surface, double x);

}  // namespace batten
