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

/// How a grid is made fair.
enum class SurfaceEngine {
    gauss_newton,  ///< all nodes at once: fourth differences, then curvature
    filter,        ///< the paper's step, node by node
};

constexpr std::array<Named<SurfaceEngine>, 2> names_of(SurfaceEngine) {
    return {{{"gauss-newton", SurfaceEngine::gauss_newton}, {"filter", SurfaceEngine::filter}}};
}

/// Which curvature becomes even.
enum class SurfaceTarget { gaussian, mean };

constexpr std::array<Named<SurfaceTarget>, 2> names_of(SurfaceTarget) {
    return {{{"gaussian", SurfaceTarget::gaussian}, {"mean", SurfaceTarget::mean}}};
}

/// Which of its two solutions the paper's step takes.
enum class FilterRoot {
    nearest,  ///< the one nearest to the node where it is
    paper,    ///< the one nearest to the mean of the eight neighbours
};

constexpr std::array<Named<FilterRoot>, 2> names_of(FilterRoot) {
    return {{{"nearest", FilterRoot::nearest}, {"paper", FilterRoot::paper}}};
}

struct FairSurfaceOptions {
    std::optional<double> sigma;
    std::optional<double> weight_curvature;
    SurfaceEngine engine = SurfaceEngine::gauss_newton;
    Border border = Border::g0;
    SurfaceTarget target = SurfaceTarget::gaussian;
    int sweeps = 100;
    FilterRoot root = FilterRoot::nearest;
};

template <class Options, class Visit>
requires std::same_as<std::remove_const_t<Options>, FairSurfaceOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("sigma", o.sigma, more_than(0),
          "standard deviation of the noise in each coordinate; without it the smoothing is found by "
          "cross-validation");
    visit("weight_curvature", o.weight_curvature, between(0, 1e12),
          "what even curvature counts: 1 as much as the data for waves at the edge of what is kept; "
          "without it found (engine gauss-newton)");
    visit("engine", o.engine, anything, "how the grid is made fair");
    visit("border", o.border, anything, "what stays at the border");
    visit("target", o.target, anything, "the curvature that becomes even");
    visit("sweeps", o.sweeps, between(1, 1e6), "passes over the nodes (engine filter)");
    visit("root", o.root, anything,
          "the solution taken: nearest to the node, or to its neighbours' mean as in the paper "
          "(engine filter)");
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
    CurvatureSpread mean_curvature;
    double rms_displacement = 0;
    double max_displacement = 0;
    std::optional<double> sigma;
    std::optional<double> weight_curvature;
    int steps = 0;
    std::vector<std::string> notes;
    /// not_converged: the last step still moved nodes by more than a hundredth of sigma, or the
    /// filter found nodes without a solution, or left the grid's own size.
    Status status = Status::met;
};

template <class Report, class Visit>
requires std::same_as<std::remove_const_t<Report>, FairSurfaceReport>
void visit_fields(Report& r, Visit&& visit) {
    visit("gaussian_curvature", r.gaussian_curvature, "of the faired points");
    visit("mean_curvature", r.mean_curvature,
          "the same, positive where the surface bends to the side of its normal");
    visit("rms_displacement", r.rms_displacement, "root of the mean squared displacement");
    visit("max_displacement", r.max_displacement, "largest displacement");
    visit("sigma", r.sigma, "noise asked for, or left over");
    visit("weight_curvature", r.weight_curvature, "weight of even curvature");
    visit("steps", r.steps, "steps or sweeps made");
    visit("notes", r.notes, "what else there is to say");
}

struct SurfaceFairing {
    Grid grid;
    FairSurfaceReport report;
};

/// A noisy grid of points in space (nu x nv nodes of 3 values) made fair.
///
/// Engine gauss-newton: (1) least squares with the data and with fourth differences along all lines
/// of both directions, coordinate by coordinate, in their own modes; their weight mu is that of the
/// least error to be expected, by Mallows' criterion or without sigma by generalised
/// cross-validation, the trace being exact. (2) Displacements along the normals of (1) make
///     |u|^2 + mu |D4 u|^2 + w |grad K|^2
/// least, K the Gaussian or the mean curvature, by Gauss-Newton steps with conjugate gradients;
/// w grows as long as the error to be expected falls. Uneven grids: differences are divided by the
/// mean distances of lines, so nodes keep their spacing.
/// Engine filter: [MiuraYoshidaSaito, section 5.3], 0.3 of its step, normals S_u x S_v. Unstable by
/// construction where the Gaussian curvature is not positive: said in the report.
/// Laws:   grid and sigma x 2^k give the grid x 2^k, exactly
/// Cost:   10 us a node at 256 x 256; the modes of n lines cost some 10 n^3 multiplications.
/// Throws: `grid.dimension` unless nodes have 3 values, `grid.too-small` below 7 x 7 nodes,
///         `grid.holes` where nodes are missing, `grid.repeated` where two neighbouring lines lie
///         on one another, `points.not-finite`, `option.range`.
/// Source: [CravenWahba1979], [Mallows1973], [MiuraYoshidaSaito].
SurfaceFairing fair_surface(const GridView& grid, const FairSurfaceOptions& options);

/// The curvatures at inner node (i, j) of a grid of points in space, by three-point differences over
/// the chords to its neighbours. 0 where the differences along u and v are parallel.
double gaussian_curvature(const GridView& grid, std::size_t i, std::size_t j);
double mean_curvature(const GridView& grid, std::size_t i, std::size_t j);

}  // namespace batten
