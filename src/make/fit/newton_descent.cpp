#include <algorithm>
#include <cmath>

#include "make/fit/knot_descent.hpp"
#include "make/fit/knot_moves.hpp"
#include "num/symmetric.hpp"

namespace batten::fitting {
namespace {

using num::SymmetricMatrix;

constexpr double meeting = 1e-3;          // gap / smaller outer gap where a double knot is tried
constexpr double newton_gain_enough = 1e-9;      // predicted gain / delta2 that ends the search
constexpr double difference_step = 1e-5;  // of the smaller gap: error about 1e-10 of the gradient
constexpr double most_damping = 1e12;
constexpr double flat = 1e-5;             // scaled eigenvalue: no curvature in this direction

/// The Hessian by central differences of the exact gradient, made symmetric.
SymmetricMatrix hessian(FreeFit& fit, const KnotSet& set) {
    const std::size_t m = set.size();
    SymmetricMatrix h(m);
    std::vector<double> up, down;
    for (std::size_t j = 0; j < m; ++j) {
        const double step =
            difference_step * std::min(gap_before(fit, set, j), gap_after(fit, set, j));
        KnotSet near = set;
        near.at[j] = set.at[j] + step;
        const double hi = near.at[j];
        fit.gradient(near, up);
        near.at[j] = set.at[j] - step;
        const double width = hi - near.at[j];
        fit.gradient(near, down);
        for (std::size_t i = 0; i < m; ++i) {
            const double half = 0.5 * ((up[i] - down[i]) / width);
            h(i, j) += half;
            h(j, i) += half;
        }
    }
    return h;
}

/// Diagonal of the Gauss-Newton matrix, none far below the largest.
std::vector<double> scales(const std::vector<double>& products, std::size_t m, double least) {
    std::vector<double> scale(m);
    for (std::size_t j = 0; j < m; ++j) scale[j] = 2 * products[j * m + j];
    const double largest = m > 0 ? *std::max_element(scale.begin(), scale.end()) : 0;
    for (double& s : scale) s += least * largest;
    return scale;
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

/// delta2 near the present knots: gradient, Hessian, and how each knot is damped.
struct Landscape {
    std::vector<double> gradient;
    SymmetricMatrix hessian;
    std::vector<double> scale;
};

struct Damping {
    double lambda = 1e-3;
    double growth = 2;
};

/// One damped step; takes it if it lowers delta2, else raises the damping.
enum class StepResult { taken, refused, at_minimum };

StepResult try_step(FreeFit& fit, Descent& here, const Landscape& land, Damping& damping) {
    const std::size_t m = land.scale.size();
    SymmetricMatrix damped = land.hessian;
    for (std::size_t i = 0; i < m; ++i) damped(i, i) += damping.lambda * land.scale[i];
    if (auto solved = num::solve_positive(damped, land.gradient)) {
        std::vector<double>& step = *solved;
        for (double& s : step) s = -s;
        const std::vector<double> bent = num::product(land.hessian, step);
        double gain = 0;
        for (std::size_t i = 0; i < m; ++i) gain -= step[i] * (land.gradient[i] + 0.5 * bent[i]);
        if (gain <= newton_gain_enough * here.delta2 && damping.lambda <= 1) return StepResult::at_minimum;
        const KnotSet next = moved(here.set, step, step_share(fit, here.set, step));
        const double value = is_ordered(fit, next) ? fit.value(next) : here.delta2;
        if (value < here.delta2) {
            const double ratio = (here.delta2 - value) / gain;
            here.set = next;
            here.delta2 = value;
            damping.lambda *= ratio > 0.75 ? 0.1 : ratio > 0.25 ? 0.5 : 2;
            damping = {std::max(damping.lambda, 1e-9), 2};
            return StepResult::taken;
        }
    }
    damping.lambda *= damping.growth;
    damping.growth *= 2;
    return damping.lambda > most_damping ? StepResult::at_minimum : StepResult::refused;
}

}  // namespace

Descent newton_descent(FreeFit& fit, KnotSet start, int steps) {
    Descent here{std::move(start), 0, 0, false};
    std::vector<double> g, products;
    Damping damping;
    here.delta2 = fit.value(here.set);
    while (here.steps < steps && here.set.size() > 0 && std::isfinite(here.delta2)) {
        ++here.steps;
        fit.normal_matrix(here.set, g, products);
        const Landscape land{g, hessian(fit, here.set), scales(products, here.set.size(), 1e-12)};
        StepResult result = StepResult::refused;
        while (result == StepResult::refused) result = try_step(fit, here, land, damping);
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
    SymmetricMatrix h = hessian(fit, set);
    const std::vector<double> scale = scales(products, set.size(), 1e-18);
    for (std::size_t i = 0; i < set.size(); ++i) {
        for (std::size_t j = 0; j < set.size(); ++j) h(i, j) /= std::sqrt(scale[i] * scale[j]);
    }
    return num::least_eigenvalue(std::move(h)) < flat;
}

}  // namespace batten::fitting
