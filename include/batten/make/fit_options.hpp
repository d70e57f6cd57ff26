#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/progress.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/make/stop_rule.hpp"

namespace batten {

/// Where the knots of a fit come from.
enum class KnotPlacement {
    automatic,  ///< one at a time, in the middle of the interval that fits worst (KPROG = 2)
    equal,      ///< intervals of equal length
    given,      ///< `knots_values`: the interior knots, repeated for multiplicity (KPROG = 1)
    free,       ///< moved to where they serve best (KPROG = 3)
    pruned,     ///< inserted, then taken out, moved and stacked one at a time
};

constexpr std::array<Named<KnotPlacement>, 5> names_of(KnotPlacement) {
    return {{{"auto", KnotPlacement::automatic},
             {"equal", KnotPlacement::equal},
             {"given", KnotPlacement::given},
             {"free", KnotPlacement::free},
             {"pruned", KnotPlacement::pruned}}};
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

constexpr Robust bare_word(Robust) { return Robust::reject; }

/// Which way a fit must go throughout: rise or fall, bend up or down.
enum class Direction {
    free,
    by_data,  ///< one way, the one the data go
    up,
    down,
};

constexpr std::array<Named<Direction>, 4> names_of(Direction) {
    return {{{"free", Direction::free},
             {"by-data", Direction::by_data},
             {"up", Direction::up},
             {"down", Direction::down}}};
}

constexpr Direction bare_word(Direction) { return Direction::by_data; }

struct FitOptions {
    int degree = 3;
    KnotPlacement knots = KnotPlacement::automatic;
    std::vector<double> knots_values;
    std::optional<int> intervals;
    std::optional<double> free_from;
    StopRule stop = StopRule::bic;
    std::vector<double> distribution;
    std::optional<double> delta2;
    std::optional<Tolerance> tolerance;
    std::optional<double> sigma;
    std::vector<double> sigma_model;
    Robust robust = Robust::none;
    bool closed = false;
    Direction monotone = Direction::free;
    Direction convex = Direction::free;
    std::optional<double> start_value, start_slope, end_value, end_slope;
    bool fix_ends = false;
    std::vector<double> start_tangent, end_tangent;
    int suggest = 0;
    int corrections = 10;
    Progress progress;  ///< told at every refit; may stop the work, which throws `Cancelled`
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, FitOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("degree", o.degree, between(0, 9), "polynomial degree of each interval");
    visit("knots", o.knots, anything, "where the knots come from, or the knots themselves");
    visit("knots_values", o.knots_values, anything,
          "knots, rising, repeated for multiplicity; the ends may be left out");
    visit("intervals", o.intervals, between(1, 1e6), "exactly so many intervals");
    visit("free_from", o.free_from, more_than(0),
          "insert knots until delta2 is below this, then insert and move them");
    visit("stop", o.stop, anything, "the rule that decides on the number of intervals");
    visit("distribution", o.distribution, between(0, 1),
          "probabilities of |error| <= 1 sigma, 2 sigma, ...; those missing are 1; without any "
          "0.68,0.95,0.99");
    visit("delta2", o.delta2, more_than(0),
          "add knots, at first many at a time, until the weighted sum of squared residuals is "
          "at most this");
    visit("tolerance", o.tolerance, anything,
          "few knots, but no residual above this");
    visit("sigma", o.sigma, more_than(0), "the error of every ordinate, one standard deviation");
    visit("sigma_model", o.sigma_model, anything, "A,B: the errors are sqrt(A y + B)");
    visit("robust", o.robust, anything, "what is done about outliers");
    visit("closed", o.closed, anything, "periodic: the end continues at the start");
    visit("monotone", o.monotone, anything, "rise (up) or fall (down) throughout");
    visit("convex", o.convex, anything, "bend up (convex) or down (concave) throughout");
    visit("start_value", o.start_value, anything, "the value at the first abscissa, exactly");
    visit("start_slope", o.start_slope, anything, "the derivative there");
    visit("end_value", o.end_value, anything, "the value at the last abscissa, exactly");
    visit("end_slope", o.end_slope, anything, "the derivative there");
    visit("fix_ends", o.fix_ends, anything,
          "parametric curves: through the first and the last point, exactly");
    visit("start_tangent", o.start_tangent, anything,
          "parametric curves: the direction at the start, of any length: DX,DY[,DZ]");
    visit("end_tangent", o.end_tangent, anything, "the direction at the end");
    visit("suggest", o.suggest, between(0, 1000),
          "so many abscissae where a further measurement narrows the mean band most");
    visit("corrections", o.corrections, between(0, 1000),
          "parametric curves: how often the points' parameters are corrected at most");
}

}  // namespace batten
