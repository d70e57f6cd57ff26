#pragma once

#include <span>

#include "batten/make/fit_surface_report.hpp"
#include "batten/shape/curved_knot_surface.hpp"
#include "batten/shape/spline_surface.hpp"

namespace batten::surface_fitting {

/// Shares of the surface's values on the grid that no u(x) + v(y), and no u(x) v(y), explains: the
/// first of the variation around the mean, the second of the sum of squares. 0 where there is none.
/// Cost: p min(m, n) operations: from the coefficients' values at their Greville places.
Separability separability(const SplineSurface& surface, std::span<const double> x,
                          std::span<const double> y);
Separability separability(const CurvedKnotSurface& surface, std::span<const double> x,
                          std::span<const double> y);

/// The root mean square, over all cells of the grid, of the surface in the middle of a cell less
/// the mean of its four corners, against the same over cells twice as large divided by 4: about 1
/// for smooth surfaces, large where the surface swings between nodes; 0 for what bends by less than
/// 1e-10 of the largest height.
double oscillation(const SplineSurface& surface, std::span<const double> x,
                   std::span<const double> y);
double oscillation(const CurvedKnotSurface& surface, std::span<const double> x,
                   std::span<const double> y);

}  // namespace batten::surface_fitting
