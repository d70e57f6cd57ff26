#pragma once

#include <limits>
#include <vector>

#include "make/fit_surface/front_model.hpp"

/// Descents of bundles of knot lines, and which of them are kept.
namespace batten::surface_fitting {

struct FrontDescent {
    FrontShape shape;
    std::vector<double> theta;
    FrontState state;
    int steps = 0;
    bool is_converged = false;
};

/// A descent that may win.
struct FrontTrial {
    FrontDescent descent;
    int jumps = 0;                                         ///< bundles that were run together
    double bic = std::numeric_limits<double>::infinity();  ///< moved parameters charged

    /// The gaps of a jump are no parameters.
    int moved() const {
        return descent.shape.parameters() - jumps * (descent.shape.bundle - 1);
    }
};

FrontTrial trial_of(const Nodes& nodes, FrontDescent descent, int jumps);

/// What is left a node, by the paper's count.
double sigma2_of(const Nodes& nodes, const FrontTrial& trial);

/// The width of a cell across the fronts.
double cell_of(const Nodes& nodes);

/// The parameters of another shape for the same fronts, nowhere narrower than half a cell, and not
/// so narrow that a spline would be without nodes.
std::vector<double> carried_over(const Nodes& nodes, const FrontDescent& from,
                                 const FrontShape& to);

/// The descent from there, its bundles as they are or run together: the best one.
FrontTrial best_trial(const Nodes& nodes, const FrontShape& shape, std::vector<double> start,
                      int most_steps);

}  // namespace batten::surface_fitting
