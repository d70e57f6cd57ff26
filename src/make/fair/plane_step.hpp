#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "make/fair/track.hpp"
#include "num/band_givens.hpp"

namespace batten::fairing {

/// What is asked of the points: near the data, and fair.
struct PlaneGoal {
    Track data;
    double sigma = 1;
    double bound = 0;          ///< no point moves further than this from its datum; 0: no bound
    std::size_t held_ends = 0;  ///< so many points at each end stay
};

/// What fair means, and how much it counts.
struct Stage {
    double alpha = -1;
    double lambda = 0;
    double softness = 0;  ///< curvatures below this share of the typical one count as small
};

/// One planar fairing: minimise
///     sum (n_i (X_i - D_i))^2 / sigma^2 + lambda sum h_i R_i^2,
///     R = kappa'' - (1 + alpha) kappa'^2 kappa / (kappa^2 + eps^2),
/// over displacements along the normals n_i by Gauss-Newton steps; h_i is half of the two edges.
class PlaneFairing {
public:
    PlaneFairing(const PlaneGoal& goal, Track start);

    const Track& track() const { return track_; }
    void restart(Track track) {
        track_ = std::move(track);
        std::fill(active_.begin(), active_.end(), 0);
    }
    int steps() const { return steps_; }
    /// The largest move of a point that the last step made, or asked for where it lowered nothing.
    double last_move() const { return last_move_; }

    /// Steps until no point moves further than `move`, or `most_steps`; whether it came to rest.
    bool run(const Stage& stage, double move, int most_steps);
    /// The root of the mean squared normal displacement of the points that may move.
    double rms() const;
    double typical_curvature() const;

private:
    void linearise(const Stage& stage);
    double objective() const;
    void find_change();
    double relaxed(double share) const;
    template <std::size_t Border>
    void solve(num::BandGivens<Border, 1>& system);
    std::vector<double> pulls() const;
    double room(std::size_t i) const;
    bool update_active();
    void solve_change();
    void find_feasible_change();
    bool is_held(std::size_t i) const;
    void move(double share, const Track& from);

    const PlaneGoal& goal_;
    Track track_;
    int steps_ = 0;
    double last_move_ = 0;
    double stage_eps_sq_ = 0;
    bool is_cut_ = false;  ///< the step ended at somebody's bound
    std::vector<double> nx_, ny_, edge_, kappa_, offset_, side_;
    std::vector<Bend> bends_;
    struct FairRow {
        double c[5], rest;  ///< R row, weighted: columns i - 2 ... i + 2
    };
    std::vector<FairRow> rows_;
    std::vector<double> change_, last_change_;
    std::vector<signed char> active_;  ///< -1, 0, 1: at the lower bound, free, at the upper one
    num::BandGivens<0, 1> open_;
    num::BandGivens<4, 1> ring_;
};

}  // namespace batten::fairing
