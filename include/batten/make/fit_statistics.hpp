#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace batten {

/// Whether the errors of the data are known, or only their ratios.
enum class SigmaKnowledge { known, unknown };

/// The numbers that compare fits with different numbers of parameters.
struct FitCriteria {
    double delta2 = 0;             ///< weighted sum of squared residuals
    std::optional<double> sigma2;  ///< delta2 / (N - p); nothing where N = p
    double aic = 0;                ///< N ln delta2 + 2 p [Hatano, eq. 2.7]
    double aicc = 0;               ///< aic + 2 p (p + 1) / (N - p - 1); aic where N <= p + 1
    double bic = 0;   ///< delta2 + p ln N (known), N ln(delta2 / N) + p ln N (unknown)
    double gcv = 0;   ///< N delta2 / (N - p)^2 [CravenWahba1979]; delta2 where N = p
};

template <class Visit>
void visit_fields(const FitCriteria& r, Visit&& visit) {
    visit("delta2", r.delta2, "weighted sum of squared residuals");
    visit("sigma2", r.sigma2, "delta2 / (N - p); none where N = p");
    visit("aic", r.aic, "N ln delta2 + 2 p");
    visit("bic", r.bic, "delta2 + p ln N with sigma known, N ln(delta2 / N) + p ln N without");
    visit("aicc", r.aicc, "aic + 2 p (p + 1) / (N - p - 1)");
    visit("gcv", r.gcv, "N delta2 / (N - p)^2");
}

/// `samples` N >= `parameters` p >= 1, delta2 >= 0. The logarithm of a delta2 of 0 is taken as that
/// of the smallest positive double.
FitCriteria fit_criteria(double delta2, std::size_t samples, int parameters,
                         SigmaKnowledge knowledge);

/// Probability that chi-square with `degrees` degrees of freedom exceeds `delta2`.
double chi2_survival(double delta2, double degrees);
/// The value that chi-square with `degrees` degrees of freedom exceeds with probability `tail`.
double chi2_quantile(double tail, double degrees);
/// The value that |t| with `degrees` degrees of freedom exceeds with probability `tail`.
double student_quantile(double tail, double degrees);

/// Probability of so few runs, or fewer, of equal signs among residuals in rising x: normal
/// approximation with continuity correction [WaldWolfowitz1940]; nothing for fewer than 10
/// residuals of either sign.
std::optional<double> runs_probability(std::size_t runs, std::size_t positive,
                                       std::size_t negative);

constexpr int psi_count = 10;
using Psi = std::array<double, psi_count>;

/// The paper's error distribution: probabilities of |error| <= i sigma, those missing 1; nothing
/// given is that of normal errors, 0.68, 0.95, 0.99, as in the paper.
/// Throws `fit.distribution` where they fall, are not above 0, exceed 1, or are more than 10.
Psi error_distribution(std::span<const double> given);

/// The paper's stopping test: psi_i >= phi_i for all i.
///
/// differs from [Hatano, step (i)], printed with <=: only >= makes the loop stop where the paper's
/// figures stop, see docs/fitting.md.
bool is_distributed(std::span<const double> psi, const Psi& phi);

}  // namespace batten
