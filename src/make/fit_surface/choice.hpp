#pragma once

#include <string>
#include <vector>

#include "make/fit_surface/cloud.hpp"
#include "make/fit_surface/nodes.hpp"

namespace batten::surface_fitting {

/// The knots of a surface fit, and how they were found.
struct SurfaceChoice {
    std::vector<double> x_knots, y_knots;  ///< full vectors
    std::vector<SurfaceStep> path;
    std::vector<std::string> notes;
    int moved = 0;  ///< knot lines whose places were optimised
    bool is_met = true;
    bool is_converged = true;
    std::optional<Axis> x = {}, y = {};     ///< where they are known already
    std::optional<Solution> solution = {};  ///< the same, with its misfit
    Misfit misfit = {};
};

/// Throws `fit.options`, `fit.knots`, `fit.intervals`, `fit.distribution`, `fit.too-few`.
SurfaceChoice choose_lines(const Nodes& nodes, const FitSurfaceOptions& options);
SurfaceChoice choose_lines(const Cloud& cloud, const FitSurfaceOptions& options);

/// `degree + 1` times the ends, the interior knots between.
std::vector<double> clamped_knots(std::span<const double> breaks, int degree);

}  // namespace batten::surface_fitting
