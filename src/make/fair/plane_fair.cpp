#include "make/fair/plane_fair.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fair/coarse.hpp"
#include "make/fair/smooth.hpp"
#include "make/fair/stages.hpp"
#include "make/fair/thin.hpp"

namespace batten::fairing {
namespace {

constexpr double rough_move = 0.02, fine_move = 1e-3;  ///< of sigma, where steps end
constexpr int rough_steps = 12, fine_steps = 60;
constexpr double shortest_curve = 8;  ///< sigma: a shorter one drowns in its noise
constexpr std::size_t smallest_ring = 9;
constexpr double longest_wave = 1500;  ///< points

/// lambda for a cutoff wavelength: data and fairness weigh alike for that wave.
double lambda_of(double wave, double spacing, double sigma) {
    return std::pow(wave / (2 * std::numbers::pi), 8) / (spacing * sigma * sigma);
}

/// The first point where the track turns back by more than a right angle, if there is one.
std::optional<std::size_t> fold_of(const Track& t) {
    for (std::size_t i = t.closed ? 0 : 1; i + (t.closed ? 0 : 1) < t.size(); ++i) {
        const std::size_t b = t.before(i), a = t.next(i);
        const double forward = (t.x[i] - t.x[b]) * (t.x[a] - t.x[i]) +
                               (t.y[i] - t.y[b]) * (t.y[a] - t.y[i]);
        if (!(forward > 0)) return i;
    }
    return std::nullopt;
}

void keep_within(const PlaneGoal& goal, Track& track) {
    for (std::size_t i = 0; i < track.size(); ++i) {
        const double dx = track.x[i] - goal.data.x[i], dy = track.y[i] - goal.data.y[i];
        const double share = std::fmin(1, goal.bound / std::hypot(dx, dy));
        if (!(share < 1)) continue;
        track.x[i] = goal.data.x[i] + share * dx;
        track.y[i] = goal.data.y[i] + share * dy;
    }
}

/// The data, or smoothed ones where their noise would fold the polyline.
Track start_of(const PlaneGoal& goal) {
    const double spacing = length_of(goal.data) / static_cast<double>(goal.data.edges());
    const auto fold = fold_of(goal.data);
    if (goal.sigma < 0.1 * spacing && !fold) return goal.data;
    Track smooth = smoothed(goal.data, cross_validated(goal.data, goal.held_ends), goal.held_ends);
    const auto still = fold_of(smooth);
    if (still || length_of(smooth) < shortest_curve * goal.sigma) {
        const std::size_t at = still.value_or(0);
        throw Error("fair.folds", "point " + std::to_string(at), format_number(goal.sigma),
                    "the noise is too large for the spacing: even smoothed the points turn back",
                    {at});
    }
    if (goal.bound > 0) keep_within(goal, smooth);
    return smooth;
}

/// The continuation of one fairing through stages.
class Continuation {
public:
    Continuation(const PlaneGoal& goal, const PlaneWish& wish)
        : goal_(goal), wish_(wish), fairing_(goal, start_of(goal)),
          length_(length_of(fairing_.track())),
          spacing_(length_ / static_cast<double>(goal.data.edges())) {}

    PlaneResult run() {
        wish_.lambda ? with_lambda(std::fmin(*wish_.lambda, longest())) : with_sigma();
        return {fairing_.track(), lambda_, fairing_.steps(), converged_, fairing_.rms(),
                fairing_.last_move()};
    }

private:
    /// Of longer waves fourth derivatives are lost to rounding.
    double longest() const { return lambda_of(longest_wave * spacing_, spacing_, goal_.sigma); }
    /// Four points; more where the noise left in such a wave would turn the normals.
    double shortest_wave() const {
        constexpr double gentle = 60;  // 2 pi over a tenth of a radian
        return std::fmax(4 * spacing_, std::cbrt(std::pow(gentle * goal_.sigma, 2) * spacing_));
    }
    bool is_clothoid() const { return wish_.alpha == -1; }

    /// Whether the points came to rest.
    bool rough(double alpha, double lambda, double softness) {
        return fairing_.run({alpha, lambda, softness}, rough_move * goal_.sigma, rough_steps);
    }
    void fine(double lambda) {
        lambda_ = lambda;
        converged_ = fairing_.run({wish_.alpha, lambda, is_clothoid() ? 0 : hard},
                                  fine_move * goal_.sigma, fine_steps);
    }

    /// From a small lambda, so that no step leads far away.
    void with_lambda(double lambda) {
        const double small = std::fmin(lambda, lambda_of(1.5 * shortest_wave(), spacing_, goal_.sigma));
        double at = std::fmax(small, lambda * 1e-4);
        if (at < lambda) rough(-1, at, 0);
        if (!is_clothoid()) {
            at = std::fmax(at, lambda * 1e-2);
            rough(wish_.alpha, at, soft);
        }
        fine(lambda);
    }

    /// Where points crowd, as round a nose, waves shorter than the mean spacing tells are shape and
    /// no noise: from displacements far beyond sigma lambda goes down as long as the estimated
    /// error falls, each time from the start.
    double gentle_enough(double lambda) {
        const Track start = start_of(goal_);
        double error = expected_error(lambda);
        while (fairing_.rms() > most_rms * goal_.sigma || lambda < first_lambda()) {
            const Track before = fairing_.track();
            fairing_.restart(start);
            rough(-1, lambda / ratio, 0);
            const double less = expected_error(lambda / ratio);
            if (!(less < error)) {
                fairing_.restart(before);
                break;
            }
            lambda /= ratio;
            error = less;
        }
        return lambda;
    }
    double first_lambda() const { return lambda_of(shortest_wave(), spacing_, goal_.sigma); }

    /// Raises lambda as long as the estimated error falls; clothoids first.
    void with_sigma() {
        const double largest = std::fmin(lambda_of(2 * length_, spacing_, goal_.sigma), longest());
        double lambda = first_lambda();
        rough(-1, lambda, 0);
        lambda = gentle_enough(lambda);
        lambda = best_from(-1, 0, lambda, largest);
        if (!is_clothoid()) {
            lambda /= ratio;
            rough(wish_.alpha, lambda, soft);
            lambda = best_from(wish_.alpha, hard, lambda, largest);
        }
        fine(lambda);
    }

    /// How many parameters lambda leaves free: waves (j - 1.5) pi / length, 4 without resistance.
    double freedom(double lambda) const {
        const bool ring = goal_.data.closed;
        const double stiff = lambda * spacing_ * goal_.sigma * goal_.sigma;
        double sum = ring ? 1 : 4 - 2 * static_cast<double>(std::min<std::size_t>(goal_.held_ends, 2));
        for (std::size_t j = ring ? 1 : 4; j < goal_.data.size(); ++j) {
            const double waves = ring ? 2 * static_cast<double>((j + 1) / 2)
                                      : static_cast<double>(j) - 1.5;
            const double resisted = stiff * std::pow(waves * std::numbers::pi / length_, 8);
            sum += 1 / (1 + resisted);
            if (resisted > 1e6) break;
        }
        return std::fmax(sum, 0);
    }

    /// The squared distance from the truth that is to be expected, but for a constant, over
    /// sigma^2 [Mallows1973].
    double expected_error(double lambda) const {
        const double rms = fairing_.rms() / goal_.sigma;
        return rms * rms + 4 * freedom(lambda) / static_cast<double>(goal_.data.size());
    }

    /// The lambda of least expected error at or above the one given; the track is the one it makes.
    /// Displacements far beyond sigma end the search: a far minimum is not meant.
    double best_from(double alpha, double softness, double lambda, double largest) {
        Track best = fairing_.track();
        double best_lambda = lambda, least = expected_error(lambda);
        for (double factor : {ratio, std::sqrt(ratio)}) {
            for (double at = best_lambda; at < largest;) {
                at = std::fmin(at * factor, largest);
                const bool rests = rough(alpha, at, softness);
                const double error = expected_error(at);
                if (rests && error < least) {
                    best = fairing_.track();
                    best_lambda = at;
                    least = error;
                } else if (fairing_.rms() > most_rms * goal_.sigma || at > 1e3 * best_lambda) {
                    break;
                }
                if (factor < ratio) break;
            }
            fairing_.restart(best);
        }
        return best_lambda;
    }

    const PlaneGoal& goal_;
    const PlaneWish& wish_;
    PlaneFairing fairing_;
    double length_, spacing_;
    double lambda_ = 0;
    bool converged_ = false;
};

/// A ring needs 9 points to be solved; three times round gives the same answer three times.
PlaneResult fair_small_ring(const PlaneGoal& goal, const PlaneWish& wish) {
    PlaneGoal thrice = goal;
    const std::size_t n = goal.data.size();
    for (std::size_t i = n; i < 3 * n; ++i) {
        thrice.data.x.push_back(goal.data.x[i - n * (i / n)]);
        thrice.data.y.push_back(goal.data.y[i - n * (i / n)]);
    }
    PlaneResult result = Continuation(thrice, wish).run();
    result.track.x.resize(n);
    result.track.y.resize(n);
    return result;
}

}  // namespace

PlaneResult fair_plane(const PlaneGoal& goal, const PlaneWish& wish) {
    return is_crowded(goal.data) ? faired_thinly(goal, wish) : fair_kept(goal, wish);
}

PlaneResult fair_kept(const PlaneGoal& goal, const PlaneWish& wish) {
    if (goal.data.closed && goal.data.size() < smallest_ring) return fair_small_ring(goal, wish);
    PlaneResult result = Continuation(goal, wish).run();
    const std::size_t n = goal.data.size();
    if (static_cast<double>(n) < longest_wave) return result;
    const double spacing = length_of(result.track) / static_cast<double>(n);
    const double longest = lambda_of(longest_wave * spacing, spacing, goal.sigma);
    const bool wants_more = wish.lambda ? *wish.lambda > longest : result.lambda > 0.5 * longest;
    return wants_more ? faired_coarsely(goal, wish, result) : result;
}

}  // namespace batten::fairing
