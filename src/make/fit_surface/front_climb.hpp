#pragma once

#include <array>
#include <set>
#include <vector>

#include "batten/make/fit_surface_report.hpp"
#include "make/fit_surface/front_trial.hpp"

namespace batten::surface_fitting {

/// The most lines along a front, and intervals of it and across.
struct FrontLimits {
    int lines, intervals;
};

/// A trial as a step of the path: bic with the moved parameters charged.
SurfaceStep step_of(const Nodes& nodes, const FrontTrial& trial);

/// One line, interval or strip more or less, as long as bic falls; every shape is tried once.
class FrontClimb {
public:
    FrontClimb(const Nodes& nodes, FrontTrial start, int most_steps);

    const FrontTrial& best() const { return best_; }
    const std::vector<SurfaceStep>& path() const { return path_; }

    void run(const FrontLimits& limits);

private:
    struct Move {
        int FrontShape::*number;
        int change, least, most;
    };
    using Numbers = std::array<int, 4>;

    bool takes(const Move& move);

    const Nodes& nodes_;
    FrontTrial best_;
    std::vector<SurfaceStep> path_;
    int most_steps_;
    std::set<Numbers> tried_;
};

}  // namespace batten::surface_fitting
