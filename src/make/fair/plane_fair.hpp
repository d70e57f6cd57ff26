#pragma once

#include <optional>

#include "make/fair/plane_step.hpp"

namespace batten::fairing {

/// How hard to fair: with the lambda given, or until the displacement is sigma.
struct PlaneWish {
    double alpha = -1;
    std::optional<double> lambda;
};

/// What came of it.
struct PlaneResult {
    Track track;
    double lambda = 0;
    int steps = 0;
    bool converged = false;
    double rms = 0;  ///< of the normal displacements
    double last_move = 0;  ///< largest of a point, that the last step made or would have made
};

/// Throws `fair.folds` where even the smoothed points turn back.
PlaneResult fair_plane(const PlaneGoal& goal, const PlaneWish& wish);

/// The same for points of which none are crowded.
PlaneResult fair_kept(const PlaneGoal& goal, const PlaneWish& wish);

}  // namespace batten::fairing
