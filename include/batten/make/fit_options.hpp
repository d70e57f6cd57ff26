#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"

namespace batten {

/// Where the knots of a fit come from.
enum class KnotPlacement {
    automatic,  ///< one at a time, in the middle of the interval that fits worst (KPROG = 2)
    equal,      ///< intervals of equal length
    given,      ///< `knot_values`: the interior knots, repeated for multiplicity (KPROG = 1)
    free,       ///< moved to where they serve best (KPROG = 3)
};

constexpr std::array<Named<KnotPlacement>, 4> names_of(KnotPlacement) {
    return {{{"auto", KnotPlacement::automatic},
             {"equal", KnotPlacement::equal},
             {"given", KnotPlacement::given},
             {"free", KnotPlacement::free}}};
}

/// How the number of intervals is decided.
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

/// What is done about outliers.
enum class Robust {
    none,
    reject,  ///< samples with |residual| > 4 sigma have no weight; decided again at every refit
    huber,   ///< weight 1 up to 1.345 sigma, then falling as 1 / |residual|
    tukey,   ///< weight (1 - (residual / 4.685 sigma)^2)^2, none beyond
};

constexpr std::array<Named<Robust>, 4> names_of(Robust) {
    return {{{"none", Robust::none},
             {"reject", Robust::reject},
             {"huber", Robust::huber},
             {"tukey", Robust::tukey}}};
}

struct FitOptions {
    int degree = 3;
    KnotPlacement knots = KnotPlacement::automatic;
    std::vector<double> knot_values;
    std::optional<int> intervals;
    std::optional<double> free_from;
    StopRule stop = StopRule::bic;
    std::vector<double> distribution;
    std::optional<double> delta2;
    std::optional<double> sigma;
    std::vector<double> sigma_model;
    Robust robust = Robust::none;
    bool closed = false;
    int suggest = 0;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, FitOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("degree", o.degree, between(0, 9), "polynomial degree of each interval");
    visit("knots", o.knots, anything, "where the knots come from, or the interior knots themselves");
    visit("knot_values", o.knot_values, anything,
          "interior knots, rising; repeated for multiplicity");
    visit("intervals", o.intervals, between(1, 1e6), "exactly so many intervals");
    visit("free_from", o.free_from, more_than(0),
          "insert knots until delta2 is below this, then insert and move them");
    visit("stop", o.stop, anything, "the rule that decides on the number of intervals");
    visit("distribution", o.distribution, between(0, 1),
          "probabilities of |error| <= 1 sigma, 2 sigma, ...; those missing are 1");
    visit("delta2", o.delta2, more_than(0),
          "add knots until the weighted sum of squared residuals is at most this");
    visit("sigma", o.sigma, more_than(0), "the error of every ordinate, one standard deviation");
    visit("sigma_model", o.sigma_model, anything, "A,B: the errors are sqrt(A y + B)");
    visit("robust", o.robust, anything, "what is done about outliers");
    visit("closed", o.closed, anything, "periodic: the end continues at the start");
    visit("suggest", o.suggest, between(0, 1000),
          "so many abscissae where a further measurement narrows the mean band most");
}

}  // namespace batten
