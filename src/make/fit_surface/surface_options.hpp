#pragma once

#include "batten/make/fit_surface_options.hpp"

namespace batten::surface_fitting {

/// Throws `fit.options` where options contradict one another, `option.range` for a degree there is
/// not.
void require_surface_options(const FitSurfaceOptions& options);

/// Whether the knot lines are listed, and not to be found.
inline bool has_given_lines(const FitSurfaceOptions& options) {
    return !options.x_knots.empty() || !options.y_knots.empty() ||
           options.knots == SurfaceKnots::given;
}

}  // namespace batten::surface_fitting
