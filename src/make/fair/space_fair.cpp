#include "make/fair/space_fair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "make/fair/smooth.hpp"
#include "make/fair/space_arc.hpp"
#include "make/fair/space_point.hpp"
#include "make/fair/space_step.hpp"
#include "make/fair/stages.hpp"

namespace batten::fairing {
namespace {

constexpr double too_far = 3;  ///< sigma: the smoothing by index of unevenly spaced points
constexpr double bearable_rms = 1.5;  ///< over sigma

/// Each coordinate smoothed, all alike, by cross-validation; the data where that moves too far.
struct Start {
    SpaceTrack track;
    double wave = 0;  ///< the cutoff, in points
};

Start start_of(const SpaceGoal& goal) {
    SpaceTrack start = goal.data;
    Track xy, zx;
    for (const SpacePoint& p : goal.data) {
        xy.x.push_back(p[0]), xy.y.push_back(p[1]);
        zx.x.push_back(p[2]), zx.y.push_back(p[0]);
    }
    const double mu = std::sqrt(cross_validated(xy, goal.held_ends) *
                                cross_validated(zx, goal.held_ends));
    const Track smooth_xy = smoothed(xy, mu, goal.held_ends),
                smooth_zx = smoothed(zx, mu, goal.held_ends);
    for (std::size_t i = 0; i < start.size(); ++i) {
        start[i] = {smooth_xy.x[i], smooth_xy.y[i], smooth_zx.x[i]};
    }
    double moved_sq = 0;
    for (std::size_t i = 0; i < start.size(); ++i) {
        moved_sq += dot(start[i] - goal.data[i], start[i] - goal.data[i]);
        start[i] = within_bound(start[i], goal, i);
    }
    const double rms = std::sqrt(moved_sq / static_cast<double>(3 * start.size()));
    if (rms > too_far * goal.sigma) return {goal.data, 6};
    return {std::move(start), 2 * std::numbers::pi * std::pow(mu, 0.125)};
}

class SpaceContinuation {
public:
    explicit SpaceContinuation(const SpaceGoal& goal) : SpaceContinuation(goal, start_of(goal)) {}

    SpaceResult run() {
        double lambda = goal_.lambda ? *goal_.lambda : least_error();
        if (goal_.lambda) {
            rough(-1, -1, lambda * 1e-2, 0);
            if (is_spiral()) rough(goal_.alpha, goal_.beta, lambda * 0.1, soft);
        }
        const bool rests = fairing_.run(stage(goal_.alpha, goal_.beta, lambda, hard),
                                        1e-3 * goal_.sigma, 40);
        return {fairing_.track(), lambda, fairing_.steps(), rests, fairing_.rms()};
    }

private:
    /// A lambda and the error to be expected with it.
    struct Found {
        double lambda, error;
    };

    SpaceContinuation(const SpaceGoal& goal, Start start)
        : goal_(goal), start_(start.track), fairing_(goal, start.track) {
        const SpaceTrack& t = start.track;
        for (std::size_t i = 0; i + 1 < t.size(); ++i) length_ += norm(t[i + 1] - t[i]);
        spacing_ = length_ / static_cast<double>(t.size() - 1);
        start_wave_ = start.wave * spacing_;
    }
    bool is_spiral() const { return goal_.alpha != -1 || goal_.beta != -1; }
    double wave_of(double lambda) const {
        return 2 * std::numbers::pi *
               std::pow(lambda * spacing_ * goal_.sigma * goal_.sigma, 0.125);
    }
    double lambda_of(double wave) const {
        return std::pow(wave / (2 * std::numbers::pi), 8) /
               (spacing_ * goal_.sigma * goal_.sigma);
    }
    /// Torsion is a derivative more, over the curvature: for the same cutoff its rows are weighted
    /// by the curvature where they stand.
    SpaceStage stage(double alpha, double beta, double lambda, double softness) const {
        const double wave = wave_of(lambda) / (2 * std::numbers::pi);
        return {alpha, beta, lambda, lambda * wave * wave, softness};
    }
    bool rough(double alpha, double beta, double lambda, double softness) {
        return fairing_.run(stage(alpha, beta, lambda, softness), 0.02 * goal_.sigma, 10);
    }
    double freedom(double lambda) const {
        const double stiff = lambda * spacing_ * goal_.sigma * goal_.sigma;
        double sum = 8;
        for (std::size_t j = 4; j < goal_.data.size(); ++j) {
            const double wave = (static_cast<double>(j) - 1.5) * std::numbers::pi / length_;
            sum += 2 / (1 + stiff * std::pow(wave, 8));
        }
        return sum;
    }
    double expected_error(double lambda) const {
        const double rms = fairing_.rms() / goal_.sigma;
        return rms * rms + 2 * freedom(lambda) / static_cast<double>(goal_.data.size());
    }

    /// As in the plane: lambda rises as long as the error to be expected falls; first for linear
    /// curvature and torsion, so that no torsion changes its sign by noise when alpha and beta come.
    double least_error() {
        const double largest = lambda_of(2 * length_);
        // Curvature in space is never below 0: shorter waves than those of the start would make
        // curvature of noise.
        double lambda = std::fmin(lambda_of(start_wave_), largest);
        rough(-1, -1, lambda, 0);
        if (!is_spiral()) return best_from(-1, -1, 0, lambda, largest).lambda;
        lambda = smoothest_from(lambda, largest);
        for (const double share : {0.25, 0.5, 0.75, 1.0}) {
            rough(-1 + share * (goal_.alpha + 1), -1 + share * (goal_.beta + 1), lambda, soft);
        }
        const Found by_stages = best_from(goal_.alpha, goal_.beta, hard, lambda, largest);
        const SpaceTrack track = fairing_.track();
        const Found by_arc = best_near_arc(largest);
        if (by_arc.error < by_stages.error) return by_arc.lambda;
        fairing_.restart(track);
        return by_stages.lambda;
    }

    /// From the one arc nearest to the points, stiff first: where the points are an arc's, no stage
    /// can lead astray.
    Found best_near_arc(double largest) {
        Found best{largest, std::numeric_limits<double>::infinity()};
        std::optional<SpaceTrack> arc = arc_along(goal_, start_);
        if (!arc) return best;
        for (std::size_t i = 0; i < arc->size(); ++i) {
            const bool is_held = i < goal_.held_ends || i + goal_.held_ends >= arc->size();
            (*arc)[i] = is_held ? goal_.data[i] : within_bound((*arc)[i], goal_, i);
        }
        SpaceTrack best_track = *arc;
        for (double lambda = largest; lambda > 1e-8 * largest; lambda /= ratio * ratio) {
            fairing_.restart(*arc);
            const bool rests = rough(goal_.alpha, goal_.beta, lambda, hard);
            const double error = expected_error(lambda);
            if (!rests || !(error < best.error)) continue;
            best = {lambda, error};
            best_track = fairing_.track();
        }
        fairing_.restart(best_track);
        return best;
    }

    /// The largest lambda that linear curvature and torsion bear.
    double smoothest_from(double lambda, double largest) {
        while (lambda < largest) {
            const SpaceTrack before = fairing_.track();
            const double next = std::fmin(lambda * ratio, largest);
            const bool rests = rough(-1, -1, next, 0);
            if (!rests || fairing_.rms() > bearable_rms * goal_.sigma) {
                fairing_.restart(before);
                break;
            }
            lambda = next;
        }
        return lambda;
    }

    Found best_from(double alpha, double beta, double softness, double lambda, double largest) {
        SpaceTrack best = fairing_.track();
        double best_lambda = lambda, least = expected_error(lambda);
        while (lambda < largest) {
            lambda = std::fmin(lambda * ratio, largest);
            const bool rests = rough(alpha, beta, lambda, softness);
            const double error = expected_error(lambda);
            if (rests && error < least) {
                least = error;
                best_lambda = lambda;
                best = fairing_.track();
            } else if (fairing_.rms() > most_rms * goal_.sigma || lambda > 1e3 * best_lambda) {
                break;
            }
        }
        fairing_.restart(best);
        return {best_lambda, least};
    }

    const SpaceGoal& goal_;
    SpaceTrack start_;
    SpaceFairing fairing_;
    double length_ = 0, spacing_ = 0, start_wave_ = 0;
};

}  // namespace

SpaceResult fair_space(const SpaceGoal& goal) { return SpaceContinuation(goal).run(); }

}  // namespace batten::fairing
