#include "make/fit_surface/front_trial.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "make/fit_surface/front_jump.hpp"

namespace batten::surface_fitting {
namespace {

/// A longest step: gaps and logits are logarithms, phi is in domain units.
constexpr double longest_log_step = 0.7;
constexpr double still_front = 1e-6;  // of delta2: a descent ends where a step gains less
constexpr double longest_shift = 0.05;  // of the domain
/// A jump leaves no more than this share of what the open bundle leaves: phi lies well enough.
constexpr double good_jump = 1.02;
constexpr double hopeful_jump = 2;  // before the other parameters have followed

/// Step of Levenberg and Marquardt, cut to what the local model can be trusted for.
std::vector<double> damped_step(const FrontShape& shape, const FrontState& state, double damping) {
    const int n = shape.parameters();
    Eigen::MatrixXd normal = Eigen::Map<const Eigen::MatrixXd>(state.normal.data(), n, n);
    const double floor = 1e-12 * normal.diagonal().maxCoeff();
    for (int k = 0; k < n; ++k) {
        normal(k, k) += damping * std::max(normal(k, k), floor) + floor;
    }
    const Eigen::VectorXd step =
        -normal.ldlt().solve(Eigen::Map<const Eigen::VectorXd>(state.gradient.data(), n));
    double cut = 1;
    for (int k = 0; k < n; ++k) {
        const double most = shape.is_place(k) ? longest_shift * shape.domain.x.length()
                                                     : longest_log_step;
        if (std::fabs(step[k]) * cut > most) cut = most / std::fabs(step[k]);
    }
    std::vector<double> result(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) result[static_cast<std::size_t>(k)] = cut * step[k];
    return result;
}

FrontDescent descend_front(const Nodes& nodes, const FrontShape& shape, std::vector<double> theta,
                           int most_steps) {
    FrontDescent d{shape, std::move(theta), {}, 0, false};
    d.state = front_state(nodes, shape, d.theta, Slopes::wanted);
    double damping = 1e-2;
    while (std::isfinite(d.state.delta2) && d.steps < most_steps && damping < 1e8) {
        const std::vector<double> step = damped_step(shape, d.state, damping);
        std::vector<double> next = d.theta;
        for (std::size_t k = 0; k < next.size(); ++k) next[k] += step[k];
        ++d.steps;
        FrontState state = front_state(nodes, shape, next, Slopes::wanted);
        if (!(state.delta2 < d.state.delta2)) {
            damping *= 4;
            continue;
        }
        const double gain = d.state.delta2 - state.delta2;
        d.theta = std::move(next);
        d.state = std::move(state);
        damping = std::max(1e-9, damping * 0.3);
        if (gain <= still_front * d.state.delta2) {
            d.is_converged = true;
            break;
        }
    }
    d.is_converged = d.is_converged || damping >= 1e8;
    return d;
}

/// Where the bundles of a descent are.
std::vector<FrontStart> starts_of(const Nodes& nodes, const FrontDescent& from) {
    std::vector<FrontStart> starts;
    for (int front = 0; front < from.shape.bundles; ++front) {
        const SplineFunction phi = front_curve(from.shape, from.theta, front);
        FrontStart start{{}, bundle_width(from.shape, from.theta, front)};
        for (const double y : nodes.y) start.path.push_back(phi(y));
        starts.push_back(std::move(start));
    }
    return starts;
}

/// The logits of the lines beside, where both shapes have such.
void copy_sides(const FrontDescent& from, const FrontShape& to, std::vector<double>& theta) {
    if (from.shape.sides() != to.sides()) return;
    std::copy(from.theta.begin() + static_cast<std::ptrdiff_t>(from.shape.sides_at()),
              from.theta.end(), theta.begin() + static_cast<std::ptrdiff_t>(to.sides_at()));
}

/// The parameters of the same lines with so many intervals of phi.
std::vector<double> with_intervals(const Nodes& nodes, const FrontDescent& from, int intervals) {
    if (intervals == from.shape.front_intervals) return from.theta;
    FrontShape to = from.shape;
    to.front_intervals = intervals;
    std::vector<double> theta = front_start(to, nodes, starts_of(nodes, from));
    copy_sides(from, to, theta);
    for (int front = 0; front < to.bundles; ++front) {
        std::copy_n(from.theta.begin() + static_cast<std::ptrdiff_t>(from.shape.gaps_at(front)),
                    to.bundle - 1, theta.begin() + static_cast<std::ptrdiff_t>(to.gaps_at(front)));
    }
    return theta;
}

/// The most intervals of phi that are tried for a jump: it has to pass between nodes in every row.
constexpr int most_jump_intervals = 8;

/// The same with one more bundle run together, and as many intervals as that needs.
FrontTrial with_jump(const Nodes& nodes, const FrontTrial& from, int front, int most_steps) {
    FrontTrial best;
    FrontShape shape = from.descent.shape;
    const double open = from.descent.state.delta2;
    const int most = std::min(std::max(most_jump_intervals, shape.front_intervals),
                              static_cast<int>(nodes.y.size()) - 3);
    double before = std::numeric_limits<double>::infinity();
    for (; shape.front_intervals <= most; ++shape.front_intervals) {
        std::vector<double> theta = jump_at(
            nodes, shape, with_intervals(nodes, from.descent, shape.front_intervals), front);
        const double delta2 = front_state(nodes, shape, theta, Slopes::none).delta2;
        if (delta2 <= hopeful_jump * open) {
            FrontTrial next = trial_of(
                nodes, descend_front(nodes, shape, std::move(theta), most_steps), from.jumps + 1);
            const bool is_good = next.descent.state.delta2 <= good_jump * open;
            if (next.bic < best.bic) best = std::move(next);
            if (is_good) break;
        }
        if (delta2 > 0.5 * before) break;  // more intervals are of little help
        before = delta2;
    }
    return best;
}

}  // namespace

FrontTrial trial_of(const Nodes& nodes, FrontDescent d, int jumps) {
    FrontTrial trial{std::move(d), jumps};
    trial.bic = trial.descent.state.delta2 +
                (trial.descent.shape.coefficients() + trial.moved()) *
                    std::log(static_cast<double>(nodes.count));
    return trial;
}

double sigma2_of(const Nodes& nodes, const FrontTrial& trial) {
    return trial.descent.state.delta2 /
           (static_cast<double>(nodes.count) - trial.descent.shape.coefficients());
}

double cell_of(const Nodes& nodes) {
    return (nodes.x.back() - nodes.x.front()) / static_cast<double>(nodes.x.size() - 1);
}

std::vector<double> carried_over(const Nodes& nodes, const FrontDescent& from,
                                 const FrontShape& to) {
    std::vector<FrontStart> starts = starts_of(nodes, from);
    const double cells = to.bundle > jump_lines ? 0.3 * (to.bundle - 1) : 0.5;
    for (FrontStart& start : starts) start.width = std::max(start.width, cells * cell_of(nodes));
    std::vector<double> theta = front_start(to, nodes, starts);
    copy_sides(from, to, theta);
    return theta;
}

FrontTrial best_trial(const Nodes& nodes, const FrontShape& shape, std::vector<double> start,
                      int most_steps) {
    FrontTrial best = trial_of(
        nodes, descend_front(nodes, shape, std::move(start), most_steps), 0);
    if (shape.bundle != jump_lines || !std::isfinite(best.bic)) return best;
    for (int front = 0; front < shape.bundles; ++front) {
        FrontTrial jump = with_jump(nodes, best, front, most_steps);
        if (jump.bic < best.bic) best = std::move(jump);
    }
    return best;
}

}  // namespace batten::surface_fitting
