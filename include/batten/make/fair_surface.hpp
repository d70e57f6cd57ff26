#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/grid.hpp"

namespace batten {

/// What stays at the border of a grid.
enum class Border {
    g0,  ///< the border's points
    g1,  ///< those and the ring inside: the tangent planes
    g2,  ///< three rings: the curvatures
};

constexpr std::array<Named<Border>, 3> names_of(Border) {
    return {{{"g0", Border::g0}, {"g1", Border::g1}, {"g2", Border::g2}}};
}

struct FairSurfaceOptions {
    std::optional<double> sigma;
    Border border = Border::g0;
};

template <class Options, class Visit>
requires std::same_as<std::remove_const_t<Options>, FairSurfaceOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("sigma", o.sigma, more_than(0),
          "standard deviation of the noise in each coordinate; without it the smoothing is found by "
          "cross-validation");
    visit("border", o.border, anything, "what stays at the border");
}

/// The range of a curvature over the inner points, and its root mean square.
struct CurvatureSpread {
    double min = 0, max = 0, rms = 0;
};

template <class Report, class Visit>
requires std::same_as<std::remove_const_t<Report>, CurvatureSpread>
void visit_fields(Report& r, Visit&& visit) {
    visit("min", r.min, "least");
    visit("max", r.max, "largest");
    visit("rms", r.rms, "root mean square");
}

struct FairSurfaceReport {
    CurvatureSpread gaussian_curvature;
    double rms_displacement = 0;
    double sigma = 0;
    std::vector<std::string> notes;
    Status status = Status::met;
};

template <class Report, class Visit>
requires std::same_as<std::remove_const_t<Report>, FairSurfaceReport>
void visit_fields(Report& r, Visit&& visit) {
    visit("gaussian_curvature", r.gaussian_curvature, "of the faired points");
    visit("rms_displacement", r.rms_displacement, "root of the mean squared displacement");
    visit("sigma", r.sigma, "noise asked for, or left over");
    visit("notes", r.notes, "what else there is to say");
}

struct SurfaceFairing {
    Grid grid;
    FairSurfaceReport report;
};

/// A noisy grid of points in space (nu x nv nodes of 3 values) made fair: fourth differences along
/// both directions, least squares with the data, coordinate by coordinate.
///
/// The smoother is the product of those along u and along v, so it costs the same a node for every
/// size; its weight is that of the least error to be expected, by Mallows' criterion or without sigma by
/// generalised cross-validation, the trace being exact.
/// Spacing counts by index: uneven grids come out fair in their parameters too.
/// Laws:   grid and sigma x 2^k give the grid x 2^k, exactly
/// Cost:   20 us a node. Throws: `grid.dimension` unless nodes have 3 values, `grid.too-small`
///         below 7 x 7 nodes, `grid.holes` where nodes are missing, `points.not-finite`,
///         `option.range`.
/// Source: [CravenWahba1979], [Mallows1973].
SurfaceFairing fair_surface(const GridView& grid, const FairSurfaceOptions& options);

/// The Gaussian curvature at inner node (i, j) of a grid of points in space, by central
/// differences. 0 where the differences along u and v are parallel.
double gaussian_curvature(const GridView& grid, std::size_t i, std::size_t j);

}  // namespace batten
