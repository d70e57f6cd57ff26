#include "make/fair/surface/smoother.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace batten::fairing {
namespace {

using Eigen::Index;

constexpr double least_mu = 0.01;
/// Stiffnesses are exact to some 1e-13: this times that must stay below 1.
constexpr double most_mu = 1e11;
constexpr double mu_step = 1.7782794100389228;  // four a decade

/// 24 times the weights of the divided fourth difference over five knots.
std::array<double, 5> fourth_difference(const double* t) {
    std::array<double, 5> w;
    for (std::size_t k = 0; k < 5; ++k) {
        w[k] = 24;
        for (std::size_t l = 0; l < 5; ++l) {
            if (l != k) w[k] /= t[k] - t[l];
        }
    }
    return w;
}

/// D4' D4 over all knots, each square times the share of the line it stands for.
Plane stiffness_of(const std::vector<double>& knots, double spacing) {
    const Index n = static_cast<Index>(knots.size());
    std::vector<double> t(knots);
    for (double& x : t) x /= spacing;
    Plane a = Plane::Zero(n, n);
    for (Index i = 0; i + 4 < n; ++i) {
        const double* first = t.data() + i;
        const std::array<double, 5> w = fourth_difference(first);
        const double share = (first[4] - first[0]) / 4;
        for (Index k = 0; k < 5; ++k) {
            for (Index l = 0; l < 5; ++l) {
                a(i + k, i + l) += share * w[static_cast<std::size_t>(k)] *
                                   w[static_cast<std::size_t>(l)];
            }
        }
    }
    return a;
}

/// Data and pulls of the held nodes, in modes.
struct InModes {
    std::array<Plane, 3> data, pull;
    Plane stiffness;  ///< of every pair of modes
};

/// The held nodes of a direction, those at the start first.
Plane ends_of(const Plane& lines, Index held) {
    Plane ends(2 * held, lines.cols());
    ends << lines.topRows(held), lines.bottomRows(held);
    return ends;
}

InModes in_modes(const Planes& d, const GridAxis& u, const GridAxis& v) {
    InModes m;
    for (std::size_t k = 0; k < 3; ++k) {
        const Plane lines = d.at[k].middleCols(v.held, v.free);
        const Plane across = d.at[k].middleRows(u.held, u.free).transpose();
        const Plane pull = u.pull * ends_of(lines, u.held) +
                           (v.pull * ends_of(across, v.held)).transpose();
        m.data[k] = u.modes.transpose() * lines.middleRows(u.held, u.free) * v.modes;
        m.pull[k] = u.modes.transpose() * pull * v.modes;
    }
    m.stiffness = u.stiffness.replicate(1, v.free) + v.stiffness.transpose().replicate(u.free, 1);
    return m;
}

/// What one mu leaves: mean squared residual of a coordinate, and the share of freedom used.
struct Trial {
    double left_sq = 0, used = 0;
};

Trial trial(const InModes& m, double mu) {
    const auto kept = (1 + mu * m.stiffness.array()).inverse().eval();
    Trial t;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto rest = mu * kept * (m.stiffness.array() * m.data[k].array() + m.pull[k].array());
        t.left_sq += rest.square().sum();
    }
    const double count = static_cast<double>(m.stiffness.size());
    t.left_sq /= 3 * count;
    t.used = kept.sum() / count;
    return t;
}

struct Choice {
    double mu = least_mu, sigma_sq = 0;
};

Choice best_mu(const InModes& m, std::optional<double> sigma) {
    const double n = static_cast<double>(std::max(m.stiffness.rows(), m.stiffness.cols())) / 3;
    const double most = std::fmin(most_mu, std::pow(n, 8));
    Choice best;
    double least = std::numeric_limits<double>::infinity();
    for (double mu = least_mu; mu <= std::fmax(most, least_mu); mu *= mu_step) {
        const Trial t = trial(m, mu);
        const double free = 1 - t.used;
        const double error = sigma ? t.left_sq + 2 * *sigma * *sigma * t.used
                                   : t.left_sq / (free * free);
        if (!(error < least)) continue;
        least = error;
        best = {mu, sigma ? *sigma * *sigma : t.left_sq / free};
    }
    return best;
}

}  // namespace

GridAxis axis_of(const std::vector<double>& knots, std::size_t held) {
    GridAxis axis;
    const Index n = static_cast<Index>(knots.size());
    axis.held = static_cast<Index>(held);
    axis.free = n - 2 * axis.held;
    axis.spacing = knots.back() / static_cast<double>(n - 1);
    const Plane all = stiffness_of(knots, axis.spacing);
    const auto rows = all.middleRows(axis.held, axis.free);
    axis.pull.resize(axis.free, 2 * axis.held);
    axis.pull << rows.leftCols(axis.held), rows.rightCols(axis.held);
    const Eigen::SelfAdjointEigenSolver<Plane> solver(rows.middleCols(axis.held, axis.free));
    axis.modes = solver.eigenvectors();
    axis.stiffness = solver.eigenvalues().cwiseMax(0);
    return axis;
}

Smoothed smoothed(const Planes& data, const GridAxis& u, const GridAxis& v,
                  std::optional<double> sigma) {
    const InModes m = in_modes(data, u, v);
    const Choice choice = best_mu(m, sigma);
    Smoothed result{data, choice.mu, choice.sigma_sq};
    for (std::size_t k = 0; k < 3; ++k) {
        const Plane x = ((m.data[k] - choice.mu * m.pull[k]).array() /
                         (1 + choice.mu * m.stiffness.array()))
                            .matrix();
        result.planes.at[k].block(u.held, v.held, u.free, v.free) =
            u.modes * x * v.modes.transpose();
    }
    return result;
}

}  // namespace batten::fairing
