#include "make/fit/knot_descent.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace batten::fitting {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double least_gap = 1e-9;        // of the domain: nearer knots are refused
constexpr double meeting = 1e-3;          // gap / smaller outer gap where a double knot is tried
constexpr double gap_kept = 0.1;          // a step leaves at least this share of every gap
constexpr double gain_enough = 1e-9;      // predicted gain / delta2 that ends the search
constexpr double difference_step = 1e-5;  // of the smaller gap: error about 1e-10 of the gradient
constexpr double most_damping = 1e12;

double gap_before(const FreeFit& fit, const KnotSet& set, std::size_t j) {
    return set.at[j] - (j == 0 ? fit.domain().lo : set.at[j - 1]);
}

double gap_after(const FreeFit& fit, const KnotSet& set, std::size_t j) {
    return (j + 1 == set.size() ? fit.domain().hi : set.at[j + 1]) - set.at[j];
}

bool is_ordered(const FreeFit& fit, const KnotSet& set) {
    const double least = least_gap * fit.domain().length();
    for (std::size_t j = 0; j < set.size(); ++j) {
        if (!(gap_before(fit, set, j) > least)) return false;
    }
    return set.size() == 0 || gap_after(fit, set, set.size() - 1) > least;
}

/// The largest share of `step` that keeps gap_kept of every gap.
double step_share(const FreeFit& fit, const KnotSet& set, const VectorXd& step) {
    double share = 1;
    for (std::size_t j = 0; j <= set.size(); ++j) {
        const bool is_end = j == set.size();
        const double gap = is_end ? gap_after(fit, set, j - 1) : gap_before(fit, set, j);
        const Eigen::Index here = static_cast<Eigen::Index>(j);
        const double change = (is_end ? 0 : step[here]) - (j == 0 ? 0 : step[here - 1]);
        if (gap + change < gap_kept * gap) share = std::min(share, (gap_kept - 1) * gap / change);
    }
    return share;
}

KnotSet moved(const KnotSet& set, const VectorXd& step, double share) {
    KnotSet result = set;
    for (std::size_t j = 0; j < set.size(); ++j) {
        result.at[j] += share * step[static_cast<Eigen::Index>(j)];
    }
    return result;
}

/// The Hessian by central differences of the exact gradient, made symmetric.
MatrixXd hessian(FreeFit& fit, const KnotSet& set) {
    const Eigen::Index m = static_cast<Eigen::Index>(set.size());
    MatrixXd h(m, m);
    std::vector<double> up, down;
    for (Eigen::Index j = 0; j < m; ++j) {
        const std::size_t v = static_cast<std::size_t>(j);
        const double step =
            difference_step * std::min(gap_before(fit, set, v), gap_after(fit, set, v));
        KnotSet near = set;
        near.at[v] = set.at[v] + step;
        const double hi = near.at[v];
        fit.gradient(near, up);
        near.at[v] = set.at[v] - step;
        const double width = hi - near.at[v];
        fit.gradient(near, down);
        for (Eigen::Index i = 0; i < m; ++i) {
            const std::size_t r = static_cast<std::size_t>(i);
            h(i, j) = (up[r] - down[r]) / width;
        }
    }
    return 0.5 * (h + h.transpose());
}

/// Joins places j and j + 1.
KnotSet joined(const KnotSet& set, std::size_t j) {
    KnotSet result = set;
    const double share = static_cast<double>(set.times[j + 1]) / (set.times[j] + set.times[j + 1]);
    result.at[j] += share * (set.at[j + 1] - set.at[j]);
    result.times[j] += set.times[j + 1];
    result.at.erase(result.at.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    result.times.erase(result.times.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    return result;
}

/// Splits place j into its first and its last knot, `distance` apart.
KnotSet split_at(const KnotSet& set, std::size_t j, double distance) {
    KnotSet result = set;
    result.at[j] = set.at[j] - 0.5 * distance;
    result.times[j] = set.times[j] / 2;
    result.at.insert(result.at.begin() + static_cast<std::ptrdiff_t>(j) + 1,
                     set.at[j] + 0.5 * distance);
    result.times.insert(result.times.begin() + static_cast<std::ptrdiff_t>(j) + 1,
                        set.times[j] - set.times[j] / 2);
    return result;
}

/// Tries double knots where two knots have come near each other.
bool join_some(FreeFit& fit, Descent& here) {
    for (std::size_t j = 0; j + 1 < here.set.size(); ++j) {
        const double gap = gap_after(fit, here.set, j);
        const double outer =
            std::min(gap_before(fit, here.set, j), gap_after(fit, here.set, j + 1));
        const bool is_legal = here.set.times[j] + here.set.times[j + 1] < fit.order();
        if (!is_legal || gap > meeting * outer) continue;
        const KnotSet together = joined(here.set, j);
        const double value = fit.value(together);
        if (value <= here.delta2 * (1 + 1e-6)) {
            here.set = together;
            here.delta2 = value;
            return true;
        }
    }
    return false;
}

/// Tries multiple knots apart.
bool split_some(FreeFit& fit, Descent& here) {
    for (std::size_t j = 0; j < here.set.size(); ++j) {
        if (here.set.times[j] < 2) continue;
        const double room = std::min(gap_before(fit, here.set, j), gap_after(fit, here.set, j));
        for (const double share : {0.02, 0.2, 0.6}) {
            const KnotSet apart = split_at(here.set, j, share * room);
            const double value = fit.value(apart);
            if (value < here.delta2 * (1 - 1e-7)) {
                here.set = apart;
                here.delta2 = value;
                return true;
            }
        }
    }
    return false;
}

/// One damped step from `h`, `g`; takes it if it lowers delta2, else raises the damping.
enum class StepResult { taken, refused, at_minimum };
struct Damping {
    double lambda = 1e-3;
    double growth = 2;
};

StepResult try_step(FreeFit& fit, Descent& here, const MatrixXd& h, const VectorXd& g,
                    const VectorXd& scale, Damping& damping) {
    const MatrixXd damped = h + MatrixXd(damping.lambda * scale.asDiagonal());
    const Eigen::LLT<MatrixXd> llt(damped);
    if (llt.info() == Eigen::Success) {
        const VectorXd step = -llt.solve(g);
        const double gain = -g.dot(step) - 0.5 * step.dot(h * step);
        if (gain <= gain_enough * here.delta2 && damping.lambda <= 1) return StepResult::at_minimum;
        const double share = step_share(fit, here.set, step);
        const KnotSet next = moved(here.set, step, share);
        const double value = is_ordered(fit, next) ? fit.value(next) : here.delta2;
        if (value < here.delta2) {
            here.set = next;
            const double ratio = (here.delta2 - value) / gain;
            here.delta2 = value;
            damping.lambda *= ratio > 0.75 ? 0.1 : ratio > 0.25 ? 0.5 : 2;
            damping.lambda = std::max(damping.lambda, 1e-9);
            damping.growth = 2;
            return StepResult::taken;
        }
    }
    damping.lambda *= damping.growth;
    damping.growth *= 2;
    return damping.lambda > most_damping ? StepResult::at_minimum : StepResult::refused;
}

VectorXd as_vector(const std::vector<double>& x) {
    return Eigen::Map<const VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

/// d at / d q for Jupp's q_i = ln of the ratio of the gaps after and before knot i.
MatrixXd jupp_jacobian(const FreeFit& fit, const KnotSet& set) {
    const Eigen::Index m = static_cast<Eigen::Index>(set.size());
    const double length = fit.domain().length();
    MatrixXd t(m, m);
    for (Eigen::Index j = 0; j < m; ++j) {
        const double uj = set.at[static_cast<std::size_t>(j)] - fit.domain().lo;
        for (Eigen::Index i = 0; i < m; ++i) {
            const double ui = set.at[static_cast<std::size_t>(i)] - fit.domain().lo;
            t(j, i) = std::max(uj - ui, 0.0) - uj * ((length - ui) / length);
        }
    }
    return t;
}

/// The knots after a step in q.
KnotSet jupp_moved(const FreeFit& fit, const KnotSet& set, const VectorXd& step) {
    KnotSet result = set;
    double factor = 1, sum = gap_before(fit, set, 0);
    std::vector<double> ends{sum};
    for (std::size_t j = 0; j < set.size(); ++j) {
        factor *= std::exp(std::clamp(step[static_cast<Eigen::Index>(j)], -2.0, 2.0));
        sum += factor * gap_after(fit, set, j);
        ends.push_back(sum);
    }
    for (std::size_t j = 0; j < set.size(); ++j) {
        result.at[j] = fit.domain().lo + fit.domain().length() * (ends[j] / sum);
    }
    return result;
}

}  // namespace

Descent jupp_descent(FreeFit& fit, KnotSet start, int steps) {
    Descent here{std::move(start), 0, 0, false};
    std::vector<double> g, products;
    here.delta2 = fit.normal_matrix(here.set, g, products);
    double lambda = 1e-2;
    const Eigen::Index m = static_cast<Eigen::Index>(here.set.size());
    while (here.steps < steps && m > 0 && std::isfinite(here.delta2)) {
        ++here.steps;
        const MatrixXd t = jupp_jacobian(fit, here.set);
        const MatrixXd jtj =
            t.transpose() * Eigen::Map<const MatrixXd>(products.data(), m, m) * t;
        const VectorXd gq = 0.5 * (t.transpose() * as_vector(g));
        bool is_taken = false;
        for (int attempt = 0; attempt < 8 && !is_taken; ++attempt) {
            const VectorXd diagonal =
                jtj.diagonal().array() + 1e-12 * jtj.diagonal().maxCoeff();
            const MatrixXd damped = jtj + MatrixXd(lambda * diagonal.asDiagonal());
            const VectorXd step = -damped.ldlt().solve(gq);
            const KnotSet next = jupp_moved(fit, here.set, step);
            const double value = is_ordered(fit, next) ? fit.value(next) : here.delta2;
            is_taken = value < here.delta2;
            lambda *= is_taken ? 0.2 : 4;
            if (!is_taken) continue;
            here.is_converged = here.delta2 - value <= 1e-6 * here.delta2;
            here.set = next;
        }
        if (!is_taken || here.is_converged) break;
        here.delta2 = fit.normal_matrix(here.set, g, products);
    }
    return here;
}

Descent newton_descent(FreeFit& fit, KnotSet start, int steps) {
    Descent here{std::move(start), 0, 0, false};
    std::vector<double> g, products;
    Damping damping;
    here.delta2 = fit.value(here.set);
    while (here.steps < steps && here.set.size() > 0 && std::isfinite(here.delta2)) {
        ++here.steps;
        fit.normal_matrix(here.set, g, products);
        const Eigen::Index m = static_cast<Eigen::Index>(here.set.size());
        const VectorXd gradient = as_vector(g);
        VectorXd scale =
            2 * Eigen::Map<const MatrixXd>(products.data(), m, m).diagonal();
        scale.array() += 1e-12 * scale.maxCoeff();
        const MatrixXd h = hessian(fit, here.set);
        StepResult result = StepResult::refused;
        while (result == StepResult::refused) {
            result = try_step(fit, here, h, gradient, scale, damping);
        }
        if (join_some(fit, here)) {
            damping = {};
            continue;
        }
        if (result == StepResult::taken) continue;
        if (!split_some(fit, here)) {
            here.is_converged = true;
            break;
        }
        damping = {};
    }
    return here;
}

Descent descend(FreeFit& fit, KnotSet start, Effort effort) {
    const Descent first = jupp_descent(fit, std::move(start), effort.jupp_steps);
    Descent last = newton_descent(fit, first.set, effort.newton_steps);
    last.steps += first.steps;
    return last;
}

bool is_singular(FreeFit& fit, const KnotSet& set) {
    if (set.size() == 0) return false;
    std::vector<double> g, products;
    fit.normal_matrix(set, g, products);
    const MatrixXd h = hessian(fit, set);
    const Eigen::Index m = h.rows();
    VectorXd scale = (2 * Eigen::Map<const MatrixXd>(products.data(), m, m).diagonal()).cwiseSqrt();
    const double largest = scale.maxCoeff();
    for (Eigen::Index j = 0; j < m; ++j) scale[j] = std::max(scale[j], 1e-9 * largest);
    const MatrixXd scaled = scale.cwiseInverse().asDiagonal() * h * scale.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scaled, Eigen::EigenvaluesOnly);
    return eigen.eigenvalues().minCoeff() < 1e-5;
}

}  // namespace batten::fitting
