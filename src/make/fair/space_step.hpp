#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "make/fair/space_fair.hpp"
#include "num/banded_qr.hpp"

namespace batten::fairing {

/// What fair means, and how much it counts.
struct SpaceStage {
    double alpha, beta, lambda, torsion_lambda, softness;
};

/// One fairing in space: Gauss-Newton steps over two normal displacements a point.
class SpaceFairing {
public:
    SpaceFairing(const SpaceGoal& goal, SpaceTrack start)
        : goal_(goal), track_(std::move(start)), n_(track_.size()), edge_(n_), kappa_(n_) {}

    /// Steps until no point moves further than `least_move`; whether it came to rest.
    bool run(const SpaceStage& stage, double least_move, int most_steps);
    const SpaceTrack& track() const { return track_; }
    void restart(SpaceTrack track) { track_ = std::move(track); }
    int steps() const { return steps_; }
    /// Of the displacements along both normals.
    double rms() const;

private:
    void set_frames();
    double objective(const SpaceTrack& t, const SpaceStage& stage) const;
    double curvature_rest(const SpaceTrack& t, std::size_t i, const SpaceStage& stage) const;
    double torsion_rest(const SpaceTrack& t, std::size_t e, const SpaceStage& stage) const;
    void absorb_rows(const SpaceStage& stage);
    void absorb(std::size_t first_point, std::size_t points, double rest, std::size_t row_first,
                const std::function<double(const SpaceTrack&)>& rest_of);
    bool is_held(std::size_t i) const {
        return i < goal_.held_ends || i + goal_.held_ends >= n_;
    }

    const SpaceGoal& goal_;
    SpaceTrack track_;
    std::size_t n_;
    std::vector<double> edge_, kappa_;
    std::vector<std::array<SpacePoint, 2>> normals_;
    num::BandedQr qr_;
    double kappa_sq_ = 0, tau_sq_ = 0;
    int steps_ = 0;
};

/// The point nearest to p where point i may go.
SpacePoint within_bound(const SpacePoint& p, const SpaceGoal& goal, std::size_t i);

}  // namespace batten::fairing
