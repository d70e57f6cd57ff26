#pragma once

#include "batten/io/draw/drawing.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/make/fit_surface.hpp"
#include "batten/measure/contours.hpp"
#include "batten/shape/surface.hpp"

namespace batten::api {

/// Lines of equal height as layers of a chart of y against x, one tone for all.
void add_contours(Panel& panel, const std::vector<Contour>& lines);

/// Two charts: lines of equal height over the knot lines, and the nodes whose residual is beyond
/// two standard deviations, those above and those below.
Drawing surface_fit_picture(const SurfaceFit& fit, const GridFile& grid);

/// Knot lines, and about `levels` lines of equal height where the surface is a tensor product.
Panel surface_map(const Surface& surface, int levels);
Drawing surface_picture(const Surface& surface, int levels);

constexpr int usual_levels = 10;

}  // namespace batten::api
