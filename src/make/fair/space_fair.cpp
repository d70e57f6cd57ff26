#include "make/fair/space_fair.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "make/fair/smooth.hpp"
#include "make/fair/stages.hpp"
#include "num/banded_qr.hpp"

namespace batten::fairing {
namespace {

constexpr int band = 12;  ///< six points, two unknowns each
constexpr double too_far = 3;  ///< sigma: the smoothing by index of unevenly spaced points
constexpr double bearable_rms = 1.5;  ///< over sigma

SpacePoint operator+(const SpacePoint& a, const SpacePoint& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
SpacePoint operator-(const SpacePoint& a, const SpacePoint& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
SpacePoint operator*(double s, const SpacePoint& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const SpacePoint& a, const SpacePoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
SpacePoint cross(const SpacePoint& a, const SpacePoint& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double norm(const SpacePoint& a) { return std::sqrt(dot(a, a)); }

/// Of the circle through three points.
double curvature(const SpacePoint& p, const SpacePoint& q, const SpacePoint& r) {
    const SpacePoint a = q - p, b = r - q;
    return 2 * norm(cross(a, b)) / (norm(a) * norm(b) * norm(a + b));
}

/// The sine of the angle between the planes of p, q, r and q, r, s over the mean edge.
double torsion(const SpacePoint& p, const SpacePoint& q, const SpacePoint& r,
               const SpacePoint& s) {
    const SpacePoint a = q - p, b = r - q, c = s - r;
    const SpacePoint m = cross(a, b), n = cross(b, c);
    const double size = norm(m) * norm(n) * norm(b);
    return size > 0 ? 3 * dot(cross(m, n), b) / (size * (norm(a) + norm(b) + norm(c))) : 0;
}

/// k'' - (1 + exponent) k'^2 k / (k^2 + eps^2) from three values with the steps between them.
double unfairness(const std::array<double, 3>& k, double h0, double h1, double exponent,
                  double eps_sq) {
    const double before = k[1] - k[0], after = k[2] - k[1], h = h0 + h1;
    const double slope = (h1 * before / h0 + h0 * after / h1) / h;
    const double bow = 2 * (after / h1 - before / h0) / h;
    const double size = k[1] * k[1] + eps_sq;
    return size > 0 ? bow - (1 + exponent) * slope * slope * k[1] / size : bow;
}

/// The point nearest to p where point i may go.
SpacePoint within_bound(const SpacePoint& p, const SpaceGoal& goal, std::size_t i) {
    const SpacePoint off = p - goal.data[i];
    if (goal.bound == 0 || norm(off) <= goal.bound) return p;
    return goal.data[i] + (goal.bound / norm(off)) * off;
}

struct SpaceStage {
    double alpha, beta, lambda, torsion_lambda, softness;
};

class SpaceFairing {
public:
    SpaceFairing(const SpaceGoal& goal, SpaceTrack start)
        : goal_(goal), track_(std::move(start)), n_(track_.size()), edge_(n_), kappa_(n_) {}

    bool run(const SpaceStage& stage, double least_move, int most_steps);
    const SpaceTrack& track() const { return track_; }
    void restart(SpaceTrack track) { track_ = std::move(track); }
    int steps() const { return steps_; }
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

void SpaceFairing::set_frames() {
    normals_.resize(n_);
    kappa_sq_ = tau_sq_ = 0;
    for (std::size_t i = 0; i < n_; ++i) {
        const SpacePoint along = track_[std::min(i + 1, n_ - 1)] - track_[i > 0 ? i - 1 : 0];
        // Any normal does; the axis that the tangent is furthest from gives a stable one.
        std::size_t axis = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            if (std::fabs(along[k]) < std::fabs(along[axis])) axis = k;
        }
        SpacePoint away{0, 0, 0};
        away[axis] = 1;
        const SpacePoint u = cross(along, away), v = cross(along, u);
        normals_[i] = {(1 / norm(u)) * u, (1 / norm(v)) * v};
        if (i + 1 < n_) edge_[i] = norm(track_[i + 1] - track_[i]);
    }
    for (std::size_t i = 1; i + 1 < n_; ++i) {
        const double k = curvature(track_[i - 1], track_[i], track_[i + 1]);
        kappa_[i] = k;
        kappa_sq_ += k * k / static_cast<double>(n_);
    }
    for (std::size_t e = 1; e + 2 < n_; ++e) {
        const double t = torsion(track_[e - 1], track_[e], track_[e + 1], track_[e + 2]);
        tau_sq_ += t * t / static_cast<double>(n_);
    }
}

double SpaceFairing::curvature_rest(const SpaceTrack& t, std::size_t i,
                                    const SpaceStage& stage) const {
    std::array<double, 3> k;
    for (std::size_t j = 0; j < 3; ++j) k[j] = curvature(t[i + j - 2], t[i + j - 1], t[i + j]);
    const double h0 = edge_[i - 1], h1 = edge_[i];
    return std::sqrt(0.5 * stage.lambda * (h0 + h1)) *
           unfairness(k, h0, h1, stage.alpha, stage.softness * stage.softness * kappa_sq_);
}

/// Edge e goes from point e to the next one; its torsion is that of the four points around it.
double SpaceFairing::torsion_rest(const SpaceTrack& t, std::size_t e,
                                  const SpaceStage& stage) const {
    std::array<double, 3> k;
    for (std::size_t j = 0; j < 3; ++j) {
        k[j] = torsion(t[e + j - 2], t[e + j - 1], t[e + j], t[e + j + 1]);
    }
    const double h0 = 0.5 * (edge_[e - 1] + edge_[e]), h1 = 0.5 * (edge_[e] + edge_[e + 1]);
    return 0.5 * (kappa_[e] + kappa_[e + 1]) * std::sqrt(stage.torsion_lambda * edge_[e]) *
           unfairness(k, h0, h1, stage.beta, stage.softness * stage.softness * tau_sq_);
}

double SpaceFairing::objective(const SpaceTrack& t, const SpaceStage& stage) const {
    double near = 0, fair = 0;
    for (std::size_t i = 0; i < n_; ++i) {
        for (const SpacePoint& normal : normals_[i]) {
            const double d = dot(normal, t[i] - goal_.data[i]);
            near += d * d;
        }
    }
    for (std::size_t i = 2; i + 2 < n_; ++i) {
        const double r = curvature_rest(t, i, stage);
        fair += r * r;
    }
    for (std::size_t e = 2; e + 3 < n_; ++e) {
        const double r = torsion_rest(t, e, stage);
        fair += r * r;
    }
    return near / (goal_.sigma * goal_.sigma) + fair;
}

double SpaceFairing::rms() const {
    double sum = 0;
    for (std::size_t i = 0; i < n_; ++i) {
        for (const SpacePoint& normal : normals_[i]) {
            const double d = dot(normal, track_[i] - goal_.data[i]);
            sum += d * d;
        }
    }
    return std::sqrt(0.5 * sum / static_cast<double>(n_));
}

/// One row by central differences over the displacements of a few points.
void SpaceFairing::absorb(std::size_t first_point, std::size_t points, double rest,
                          std::size_t row_first,
                          const std::function<double(const SpaceTrack&)>& rest_of) {
    std::array<double, band + 1> row{};
    for (std::size_t j = first_point; j < first_point + points; ++j) {
        if (is_held(j)) continue;
        const double step = 1e-5 * edge_[std::min(j, n_ - 2)];
        for (std::size_t k = 0; k < 2; ++k) {
            const SpacePoint here = track_[j];
            track_[j] = here + step * normals_[j][k];
            const double plus = rest_of(track_);
            track_[j] = here + -step * normals_[j][k];
            const double minus = rest_of(track_);
            track_[j] = here;
            row[2 * j + k - row_first] = (plus - minus) / (2 * step);
        }
    }
    row[band] = -rest;
    qr_.absorb(static_cast<int>(row_first), row.data(), 1);
}

void SpaceFairing::absorb_rows(const SpaceStage& stage) {
    qr_.restart({band, static_cast<int>(2 * n_), 0, 1});
    for (std::size_t p = 0; p < n_; ++p) {
        const std::size_t row_first = 2 * std::min(p, n_ - 6);
        for (std::size_t k = 0; k < 2; ++k) {
            std::array<double, band + 1> row{};
            row[2 * p + k - row_first] = 1 / goal_.sigma;
            row[band] =
                is_held(p) ? 0 : -dot(normals_[p][k], track_[p] - goal_.data[p]) / goal_.sigma;
            qr_.absorb(static_cast<int>(row_first), row.data(), 1);
        }
        if (p + 4 < n_) {
            const auto rest = [&](const SpaceTrack& t) { return curvature_rest(t, p + 2, stage); };
            absorb(p, 5, rest(track_), row_first, rest);
        }
        if (p + 5 < n_) {
            const auto rest = [&](const SpaceTrack& t) { return torsion_rest(t, p + 2, stage); };
            absorb(p, 6, rest(track_), row_first, rest);
        }
    }
    qr_.finish();
}

bool SpaceFairing::run(const SpaceStage& stage, double least_move, int most_steps) {
    std::vector<double> change(2 * n_);
    for (int i = 0; i < most_steps; ++i) {
        ++steps_;
        set_frames();
        absorb_rows(stage);
        qr_.solve(0, change);
        const SpaceTrack from = track_;
        const double value = objective(from, stage);
        double most = 0;
        for (const double c : change) most = std::fmax(most, std::fabs(c));
        bool better = false;
        for (double share = 1; share > 1e-3 && !better; share *= 0.5) {
            for (std::size_t j = 0; j < n_; ++j) {
                if (is_held(j)) continue;
                track_[j] = from[j] + (share * change[2 * j] * normals_[j][0] +
                                       share * change[2 * j + 1] * normals_[j][1]);
                track_[j] = within_bound(track_[j], goal_, j);
            }
            better = objective(track_, stage) <= value * (1 + 1e-6);
        }
        if (!better) {
            track_ = from;
            return most < 10 * least_move;
        }
        if (most < least_move) return true;
    }
    return false;
}

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
        if (goal_.lambda) rough(-1, -1, lambda * 1e-2, 0);
        if (is_spiral()) rough(goal_.alpha, goal_.beta, lambda * 0.1, soft);
        const bool rests = fairing_.run(stage(goal_.alpha, goal_.beta, lambda, hard),
                                        1e-3 * goal_.sigma, 40);
        return {fairing_.track(), lambda, fairing_.steps(), rests, fairing_.rms()};
    }

private:
    SpaceContinuation(const SpaceGoal& goal, Start start)
        : goal_(goal), fairing_(goal, start.track) {
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
    void rough(double alpha, double beta, double lambda, double softness) {
        fairing_.run(stage(alpha, beta, lambda, softness), 0.02 * goal_.sigma, 10);
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
        if (!is_spiral()) return best_from(-1, -1, 0, lambda, largest);
        lambda = smoothest_from(lambda, largest);
        for (const double share : {0.25, 0.5, 0.75, 1.0}) {
            rough(-1 + share * (goal_.alpha + 1), -1 + share * (goal_.beta + 1), lambda, soft);
        }
        return best_from(goal_.alpha, goal_.beta, hard, lambda, largest);
    }

    /// The largest lambda that linear curvature and torsion bear.
    double smoothest_from(double lambda, double largest) {
        while (lambda < largest) {
            const SpaceTrack before = fairing_.track();
            const double next = std::fmin(lambda * ratio, largest);
            rough(-1, -1, next, 0);
            if (fairing_.rms() > bearable_rms * goal_.sigma) {
                fairing_.restart(before);
                break;
            }
            lambda = next;
        }
        return lambda;
    }

    double best_from(double alpha, double beta, double softness, double lambda, double largest) {
        SpaceTrack best = fairing_.track();
        double best_lambda = lambda, least = expected_error(lambda);
        while (lambda < largest) {
            lambda = std::fmin(lambda * ratio, largest);
            rough(alpha, beta, lambda, softness);
            const double error = expected_error(lambda);
            if (error < least) {
                least = error;
                best_lambda = lambda;
                best = fairing_.track();
            } else if (fairing_.rms() > most_rms * goal_.sigma || lambda > 1e3 * best_lambda) {
                break;
            }
        }
        fairing_.restart(best);
        return best_lambda;
    }

    const SpaceGoal& goal_;
    SpaceFairing fairing_;
    double length_ = 0, spacing_ = 0, start_wave_ = 0;
};

}  // namespace

double circle_curvature_of(const SpacePoint& p, const SpacePoint& q, const SpacePoint& r) {
    return curvature(p, q, r);
}

SpaceResult fair_space(const SpaceGoal& goal) { return SpaceContinuation(goal).run(); }

}  // namespace batten::fairing
