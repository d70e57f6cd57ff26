#include "make/fair/space_step.hpp"

#include <algorithm>
#include <cmath>

#include "make/fair/space_point.hpp"

namespace batten::fairing {
namespace {

constexpr int band = 12;  ///< six points, two unknowns each

/// k'' - (1 + exponent) k'^2 k / (k^2 + eps^2) from three values with the steps between them.
double unfairness(const std::array<double, 3>& k, double h0, double h1, double exponent,
                  double eps_sq) {
    const double before = k[1] - k[0], after = k[2] - k[1], h = h0 + h1;
    const double slope = (h1 * before / h0 + h0 * after / h1) / h;
    const double bow = 2 * (after / h1 - before / h0) / h;
    const double size = k[1] * k[1] + eps_sq;
    return size > 0 ? bow - (1 + exponent) * slope * slope * k[1] / size : bow;
}

}  // namespace

SpacePoint within_bound(const SpacePoint& p, const SpaceGoal& goal, std::size_t i) {
    const SpacePoint off = p - goal.data[i];
    if (goal.bound == 0 || norm(off) <= goal.bound) return p;
    return goal.data[i] + (goal.bound / norm(off)) * off;
}

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
        const double step = 2e-7 * edge_[std::min(j, n_ - 2)];
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

}  // namespace batten::fairing
