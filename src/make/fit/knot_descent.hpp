#pragma once

#include "make/fit/free_fit.hpp"

/// From given knots to a local minimum of the reduced functional.
namespace batten::fitting {

struct Effort {
    int jupp_steps = 15;    ///< safe far away: no two knots can meet
    int newton_steps = 60;
};

struct Descent {
    KnotSet set;
    double delta2 = 0;
    int steps = 0;
    bool is_converged = false;
};

/// Levenberg-Marquardt steps in Jupp's variables, the logarithms of the ratios of gaps.
/// Source: [Jupp1978].
Descent jupp_descent(FreeFit& fit, KnotSet start, int steps);

/// Levenberg steps with the exact gradient and the Hessian of the reduced functional (central
/// differences of the gradient). Two knots that run into each other become a double knot; a
/// multiple knot that is better apart is split. Stops where the predicted gain is below 1e-9 delta2.
Descent newton_descent(FreeFit& fit, KnotSet start, int steps);

/// First one, then the other.
Descent descend(FreeFit& fit, KnotSet start, Effort effort);

/// Whether the Hessian has a direction without curvature: the knots are not unique.
bool is_singular(FreeFit& fit, const KnotSet& set);

}  // namespace batten::fitting
