#pragma once

#include <optional>

#include "make/fair/space_point.hpp"

namespace batten::fairing {

/// What is asked of an open row of points in space.
struct SpaceGoal {
    SpaceTrack data;
    double sigma = 1;
    double bound = 0;
    std::size_t held_ends = 0;
    double alpha = -1, beta = -1;
    std::optional<double> lambda;  ///< of curvature; that of torsion has the same cutoff
};

struct SpaceResult {
    SpaceTrack track;
    double lambda = 0;
    int steps = 0;
    bool converged = false;
    double rms = 0;  ///< of the displacements along both normals
};

/// Minimises over two normal displacements a point
///     sum |d|^2 / sigma^2 + lambda sum h Rk^2 + lambda_t sum h Rt^2,
///     Rk = kappa'' - (1 + alpha) kappa'^2 kappa / (kappa^2 + eps^2), Rt likewise of torsion, beta.
///
/// Curvature of three points, torsion of four, on edges; from points smoothed by generalised
/// cross-validation, then alpha = beta = -1, then what is asked. Cost: 8 us a point and step.
SpaceResult fair_space(const SpaceGoal& goal);

/// The smallest number of points that have a change of torsion.
constexpr std::size_t fewest_space_points = 7;

}  // namespace batten::fairing
