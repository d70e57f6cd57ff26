#pragma once

#include <array>

#include "batten/base/fields.hpp"
#include "batten/make/fit_statistics.hpp"

namespace batten {

/// How the number of intervals, or of strips, is decided.
enum class StopRule {
    bic,           ///< least delta2 + p ln N (sigma known), N ln(delta2 / N) + p ln N (unknown)
    distribution,  ///< first with psi_i >= phi_i for all i: the paper's rule
    chi2,          ///< first with delta2 <= the 95 % point of chi-square with N - p degrees
    aic,           ///< least N ln delta2 + 2 p, the paper's
    aicc,          ///< least aic + 2 p (p + 1) / (N - p - 1)
    gcv,           ///< least N delta2 / (N - p)^2
    none,          ///< as many as `intervals` asks for, or as can be
};

constexpr std::array<Named<StopRule>, 7> names_of(StopRule) {
    return {{{"bic", StopRule::bic},
             {"distribution", StopRule::distribution},
             {"chi2", StopRule::chi2},
             {"aic", StopRule::aic},
             {"aicc", StopRule::aicc},
             {"gcv", StopRule::gcv},
             {"none", StopRule::none}}};
}

/// Whether the rule takes the least of a criterion, not the first fit that passes a test.
constexpr bool is_criterion(StopRule rule) {
    return rule != StopRule::distribution && rule != StopRule::chi2 && rule != StopRule::none;
}

/// What the rule compares; bic for rules that compare nothing.
constexpr double criterion_of(const FitCriteria& fit, StopRule rule) {
    switch (rule) {
        case StopRule::aic: return fit.aic;
        case StopRule::aicc: return fit.aicc;
        case StopRule::gcv: return fit.gcv;
        default: return fit.bic;
    }
}

}  // namespace batten
