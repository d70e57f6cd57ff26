#pragma once

#include "batten/io/draw/drawing.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/make/fit_front.hpp"
#include "batten/make/fit_surface.hpp"
#include "batten/measure/contours.hpp"

namespace batten::api {

/// Lines of equal height as layers of a chart of y against x, one tone for all.
void add_contours(Panel& panel, const std::vector<Contour>& lines);

/// Two charts: lines of equal height over the knot lines, and the nodes whose residual is beyond
/// two standard deviations, those above and those below.
Drawing surface_fit_picture(const SurfaceFit& fit, const GridFile& grid);

/// The knot lines of a surface with a front.
Drawing front_picture(const FrontFit& fit);

}  // namespace batten::api
