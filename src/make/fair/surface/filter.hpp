#pragma once

#include "batten/make/fair_surface.hpp"
#include "make/fair/surface/planes.hpp"

namespace batten::fairing {

struct SurfaceFilterPlan {
    std::size_t held = 1;
    int sweeps = 100;
    FilterRoot root = FilterRoot::nearest;
    SurfaceTarget target = SurfaceTarget::gaussian;
};

struct SurfaceFiltered {
    Planes planes;
    int sweeps = 0;
    std::size_t rootless = 0;  ///< nodes of the last sweep for which no step exists
    double last_move = 0;
    bool burst = false;  ///< a sweep moved a node by more than the grid's extent: the one before stays
};

/// Moves every node along its normal to where its curvature is the mean of those of the nodes around
/// it and its own, by 0.3 of that way, all nodes at once.
///
/// Differences are by index, as in the paper; with the normal and the tangents frozen the Gaussian
/// curvature of a node is quadratic in its displacement phi:
///     (e - 2 phi) (g - 2 phi) - f^2 = K (E G - F^2).
/// Where no phi solves it the node stays.
/// Source: [MiuraYoshidaSaito, section 5.3]; differs from it: normals S_u x S_v, not means over
/// triangles; the root nearest to the node.
SurfaceFiltered filtered(const Planes& data, const SurfaceFilterPlan& plan);

}  // namespace batten::fairing
