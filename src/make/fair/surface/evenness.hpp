#pragma once

#include <optional>

#include "batten/make/fair_surface.hpp"
#include "make/fair/surface/smoother.hpp"

namespace batten::fairing {

/// A smoothed grid, and what its curvature should become.
struct EvennessGoal {
    const Planes& data;
    const Smoothed& smooth;
    const Knots& knots;
    const GridAxis &u, &v;
    SurfaceTarget target = SurfaceTarget::gaussian;
    std::optional<double> weight;  ///< without it: that of least error to be expected
};

struct Evened {
    Planes planes;
    double weight = 0;
    int steps = 0;
    bool converged = true;
};

/// Displacements u along the smoothed grid's normals that make
///     |u|^2 + mu |D4 u|^2 + w |grad K|^2
/// least: Gauss-Newton steps in the smooth modes of the grid, each by conjugate gradients behind
/// the mean symbol of the linearised curvature. The weight is w in units in which it equals the
/// data for the waves that the smoothing halves. Without one it rises tenfold as long as Mallows'
/// criterion for the displacements along the normals falls [Mallows1973].
Evened evened(const EvennessGoal& goal);

}  // namespace batten::fairing
