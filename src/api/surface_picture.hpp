#pragma once

#include "batten/io/draw/surface_plots.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/make/fit_front.hpp"
#include "batten/make/fit_scattered.hpp"
#include "batten/make/fit_surface.hpp"

namespace batten::api {

constexpr int usual_levels = 10;

/// About `levels` lines of equal height over the knot lines; and the same upon the surface.
Panel surface_map(const Surface& surface, int levels);
Panel surface_relief(const Surface& surface, int levels);
/// Both.
Drawing surface_picture(const Surface& surface, int levels);

/// Level lines as a map; and the same upon the surface.
Drawing contour_map(const Rectangle& domain, const std::vector<Contour>& lines);
Drawing contour_picture(const Surface& surface, const std::vector<Contour>& lines);

/// Four panels under a title and what the fit came to: the data under the knot lines, level lines, the surface in space, residuals.
Drawing surface_fit_picture(const SurfaceFit& fit, const GridFile& grid);
Drawing scattered_fit_picture(const SurfaceFit& fit, const ScatteredSamples& samples);
Drawing curved_fit_picture(const CurvedKnotSurface& surface, const FrontReport& report,
                           const GridFile& grid, double sigma);

}  // namespace batten::api
