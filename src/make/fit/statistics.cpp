#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/fit_statistics.hpp"

namespace batten {

FitCriteria fit_criteria(double delta2, std::size_t samples, int parameters,
                         SigmaKnowledge knowledge) {
    const double n = static_cast<double>(samples), p = parameters;
    const double safe = std::max(delta2, std::numeric_limits<double>::min());
    FitCriteria result;
    result.delta2 = delta2;
    if (n > p) result.sigma2 = delta2 / (n - p);
    result.aic = n * std::log(safe) + 2 * p;
    result.aicc = n > p + 1 ? result.aic + 2 * p * (p + 1) / (n - p - 1) : result.aic;
    const double misfit =
        knowledge == SigmaKnowledge::known ? delta2 : n * (std::log(safe) - std::log(n));
    result.bic = misfit + p * std::log(n);
    result.gcv = n > p ? n * (delta2 / ((n - p) * (n - p))) : delta2;
    return result;
}

double chi2_survival(double delta2, double degrees) {
    // The probability of less is at most x^a / Gamma(a + 1), as exp(-t) <= 1. Where that is nothing
    // beside 1, series for small x would ask for a Gamma beyond all numbers.
    constexpr double log_of_nothing = -40;
    const double a = 0.5 * degrees, x = 0.5 * delta2;
    if (a * std::log(x) - boost::math::lgamma(a + 1) < log_of_nothing) return 1;
    return boost::math::gamma_q(a, x);
}

double chi2_quantile(double tail, double degrees) {
    return 2 * boost::math::gamma_q_inv(0.5 * degrees, tail);
}

double student_quantile(double tail, double degrees) {
    if (degrees > 1e6) {
        return std::numbers::sqrt2 * boost::math::erfc_inv(tail);
    }
    // P(|t| > q) = I_x(degrees / 2, 1 / 2), x = degrees / (degrees + q^2) [DLMF, 8.17].
    const double x = boost::math::ibeta_inv(0.5 * degrees, 0.5, tail);
    return std::sqrt(degrees * (1 - x) / x);
}

std::optional<double> runs_probability(std::size_t runs, std::size_t positive,
                                       std::size_t negative) {
    if (positive < 10 || negative < 10) return std::nullopt;
    const double a = static_cast<double>(positive), b = static_cast<double>(negative);
    const double n = a + b;
    const double mean = 2 * a * b / n + 1;
    const double variance = (mean - 1) * (mean - 2) / (n - 1);
    const double z = (static_cast<double>(runs) + 0.5 - mean) / std::sqrt(variance);
    return 0.5 * boost::math::erfc(-z / std::numbers::sqrt2);
}

Psi error_distribution(std::span<const double> given) {
    if (given.size() > psi_count) {
        throw Error("fit.distribution", "distribution", std::to_string(given.size()),
                    "there are at most 10 probabilities");
    }
    static constexpr double of_normal_errors[] = {0.68, 0.95, 0.99};
    if (given.empty()) given = of_normal_errors;
    Psi phi;
    phi.fill(1);
    for (std::size_t i = 0; i < given.size(); ++i) {
        const double least = i == 0 ? 0 : phi[i - 1];
        if (!(given[i] > 0) || given[i] > 1 || given[i] < least) {
            throw Error("fit.distribution", "probability " + std::to_string(i + 1),
                        format_number(given[i]),
                        "must be above 0, at most 1, and not below the one before");
        }
        phi[i] = given[i];
    }
    return phi;
}

bool is_distributed(std::span<const double> psi, const Psi& phi) {
    for (std::size_t i = 0; i < psi.size(); ++i) {
        if (psi[i] < phi[i]) return false;
    }
    return true;
}

}  // namespace batten
