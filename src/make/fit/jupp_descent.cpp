#include <algorithm>
#include <cmath>

#include "make/fit/knot_descent.hpp"
#include "make/fit/knot_moves.hpp"
#include "num/symmetric.hpp"

namespace batten::fitting {
namespace {

using num::SymmetricMatrix;

constexpr int most_attempts = 8;
constexpr double jupp_gain_enough = 1e-6;  // of delta2, to go on
constexpr double most_change = 2;     // of a logarithm of a ratio of gaps, in one step

/// d at[j] / d q[i] for Jupp's q_i = ln of the ratio of the gaps after and before knot i, as
/// entries j * m + i.
std::vector<double> jupp_jacobian(const FreeFit& fit, const KnotSet& set) {
    const std::size_t m = set.size();
    const double lo = fit.domain().lo, length = fit.domain().length();
    std::vector<double> t(m * m);
    for (std::size_t j = 0; j < m; ++j) {
        const double uj = set.at[j] - lo;
        for (std::size_t i = 0; i < m; ++i) {
            const double ui = set.at[i] - lo;
            t[j * m + i] = std::max(uj - ui, 0.0) - uj * ((length - ui) / length);
        }
    }
    return t;
}

/// T^T M T.
SymmetricMatrix between(const std::vector<double>& t, const std::vector<double>& matrix,
                        std::size_t m) {
    std::vector<double> half(m * m, 0.0);  // M T
    SymmetricMatrix result(m);
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t l = 0; l < m; ++l) {
            for (std::size_t j = 0; j < m; ++j) half[i * m + j] += matrix[i * m + l] * t[l * m + j];
        }
    }
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t l = 0; l < m; ++l) {
            for (std::size_t j = 0; j < m; ++j) result(i, j) += t[l * m + i] * half[l * m + j];
        }
    }
    return result;
}

/// The knots after a step in q.
KnotSet jupp_moved(const FreeFit& fit, const KnotSet& set, const std::vector<double>& step) {
    KnotSet result = set;
    double factor = 1, sum = gap_before(fit, set, 0);
    std::vector<double> ends{sum};
    for (std::size_t j = 0; j < set.size(); ++j) {
        factor *= std::exp(std::clamp(step[j], -most_change, most_change));
        sum += factor * gap_after(fit, set, j);
        ends.push_back(sum);
    }
    for (std::size_t j = 0; j < set.size(); ++j) {
        result.at[j] = fit.domain().lo + fit.domain().length() * (ends[j] / sum);
    }
    return result;
}

/// Marquardt's step for J^T J = `matrix` and the gradient halved, `descent` its negative.
std::optional<std::vector<double>> damped_step(SymmetricMatrix matrix, double lambda,
                                               const std::vector<double>& descent) {
    double largest = 0;
    for (std::size_t i = 0; i < matrix.size; ++i) largest = std::max(largest, matrix(i, i));
    for (std::size_t i = 0; i < matrix.size; ++i) {
        matrix(i, i) += lambda * (matrix(i, i) + 1e-12 * largest);
    }
    return num::solve_positive(matrix, descent);
}

}  // namespace

Descent jupp_descent(FreeFit& fit, KnotSet start, int steps) {
    Descent here{std::move(start), 0, 0, false};
    std::vector<double> g, products;
    here.delta2 = fit.normal_matrix(here.set, g, products);
    double lambda = 1e-2;
    const std::size_t m = here.set.size();
    while (here.steps < steps && m > 0 && std::isfinite(here.delta2)) {
        ++here.steps;
        const std::vector<double> t = jupp_jacobian(fit, here.set);
        const SymmetricMatrix matrix = between(t, products, m);
        std::vector<double> descent(m, 0.0);
        for (std::size_t j = 0; j < m; ++j) {
            for (std::size_t i = 0; i < m; ++i) descent[i] -= 0.5 * t[j * m + i] * g[j];
        }
        bool is_taken = false;
        for (int attempt = 0; attempt < most_attempts && !is_taken; ++attempt) {
            const auto step = damped_step(matrix, lambda, descent);
            const KnotSet next = step ? jupp_moved(fit, here.set, *step) : here.set;
            const double value = is_ordered(fit, next) ? fit.value(next) : here.delta2;
            is_taken = value < here.delta2;
            lambda *= is_taken ? 0.2 : 4;
            if (!is_taken) continue;
            here.is_converged = here.delta2 - value <= jupp_gain_enough * here.delta2;
            here.set = next;
        }
        if (!is_taken || here.is_converged) break;
        here.delta2 = fit.normal_matrix(here.set, g, products);
    }
    return here;
}

}  // namespace batten::fitting
