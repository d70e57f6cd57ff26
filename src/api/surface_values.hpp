#pragma once

#include <vector>

#include "batten/api/operation.hpp"

namespace batten::api {

/// What `evaluate` is asked of a surface.
struct SurfaceQuestions {
    std::vector<double> at;  ///< x, y, x, y, …
    int count = 0;           ///< places a side of a grid over the domain, or 0
    int derivatives = 0;     ///< up to this order in all
    bool curvature = false;
};

/// Rows x, y, z, then the derivatives as z_x, z_y, z_xx, …, then nx, ny, nz, gaussian, mean.
/// Throws `option.value` where `at` is no list of pairs, `surface.outside`, `surface.derivative`.
Rows surface_rows(const Surface& surface, const SurfaceQuestions& questions);

/// Grid and mesh forms of a surface on the given lines: csv, npy, obj, ply, stl; and `patches`, the
/// Bezier patches as JSON. Throws `surface.patches` when those of a surface with curved knot lines
/// are asked for.
std::vector<OutputForm> surface_forms(const Surface& surface, std::vector<double> x,
                                      std::vector<double> y);

}  // namespace batten::api
