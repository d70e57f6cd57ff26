#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/make/fit_options.hpp"

namespace batten {

/// Where the knot lines of a surface come from.
enum class SurfaceKnots {
    automatic,  ///< one at a time, in the middle of the strip that fits worst
    equal,      ///< strips of equal width
    given,      ///< `x_knots` and `y_knots`
    free,       ///< automatic, equal where `intervals` are given, or given; then moved
    curved,     ///< a bundle along a front: for `fit_front`
};

constexpr std::array<Named<SurfaceKnots>, 5> names_of(SurfaceKnots) {
    return {{{"auto", SurfaceKnots::automatic},
             {"equal", SurfaceKnots::equal},
             {"given", SurfaceKnots::given},
             {"free", SurfaceKnots::free},
             {"curved", SurfaceKnots::curved}}};
}

/// How the misfit of a strip is measured when a knot line is put in.
enum class StripRule {
    projected,  ///< the residuals along the strip, projected on the splines across it
    marginal,   ///< their signed sums, squared: the paper's; blind to what changes sign across
};

constexpr std::array<Named<StripRule>, 2> names_of(StripRule) {
    return {{{"projected", StripRule::projected}, {"marginal", StripRule::marginal}}};
}

struct FitSurfaceOptions {
    int degree = 3;
    SurfaceKnots knots = SurfaceKnots::automatic;
    std::vector<double> x_knots;
    std::vector<double> y_knots;
    std::vector<double> intervals;
    StripRule rule = StripRule::projected;
    StopRule stop = StopRule::bic;
    std::vector<double> distribution;
    std::optional<double> delta2;
    std::optional<double> sigma;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, FitSurfaceOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("degree", o.degree, between(0, 9), "polynomial degree of each cell, in x and in y");
    visit("knots", o.knots, anything, "where the knot lines come from");
    visit("x_knots", o.x_knots, anything,
          "knot lines of constant x, rising, repeated for multiplicity; the ends may be left out");
    visit("y_knots", o.y_knots, anything, "knot lines of constant y");
    visit("intervals", o.intervals, between(1, 1e5), "M,N: exactly so many strips in x and in y; with lines N alone, in y");
    visit("rule", o.rule, anything, "how the misfit of a strip is measured");
    visit("stop", o.stop, anything, "the rule that decides on the number of strips");
    visit("distribution", o.distribution, between(0, 1),
          "probabilities of |error| <= 1 sigma, 2 sigma, ...; those missing are 1; without any "
          "0.68,0.95,0.99");
    visit("delta2", o.delta2, more_than(0),
          "add knot lines until the weighted sum of squared residuals is at most this");
    visit("sigma", o.sigma, more_than(0), "the error of every height, one standard deviation");
}

}  // namespace batten
