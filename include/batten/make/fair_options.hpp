#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <type_traits>

#include "batten/base/fields.hpp"
#include "batten/base/tolerance.hpp"

namespace batten {

/// How points are made fair.
enum class FairEngine {
    gauss_newton,  ///< all points at once, data and fairness in balance
    filter,        ///< the discrete filter of the paper, point after point
};

constexpr std::array<Named<FairEngine>, 2> names_of(FairEngine) {
    return {{{"gauss-newton", FairEngine::gauss_newton}, {"filter", FairEngine::filter}}};
}

/// What stays at the two ends of a row of points.
enum class FixEnds {
    none,       ///< nothing
    position,   ///< the end points
    tangent,    ///< the last two points at each end
    curvature,  ///< the last three
};

constexpr std::array<Named<FixEnds>, 4> names_of(FixEnds) {
    return {{{"none", FixEnds::none},
             {"position", FixEnds::position},
             {"tangent", FixEnds::tangent},
             {"curvature", FixEnds::curvature}}};
}
/// What the option's name alone means.
constexpr FixEnds bare_word(FixEnds) { return FixEnds::position; }

/// Where the filter puts a point between its neighbours.
enum class FairSpacing {
    equal,  ///< in their middle, as in the paper: all chords become equal
    kept,   ///< by the ratio of its own two chords
};

constexpr std::array<Named<FairSpacing>, 2> names_of(FairSpacing) {
    return {{{"equal", FairSpacing::equal}, {"kept", FairSpacing::kept}}};
}

/// What comes out.
enum class FairForm {
    points,  ///< the points, moved
    arcs,    ///< a chain of log-aesthetic arcs along them
};

constexpr std::array<Named<FairForm>, 2> names_of(FairForm) {
    return {{{"points", FairForm::points}, {"arcs", FairForm::arcs}}};
}

/// What is asked; `visit_fields` says what each member means.
struct FairOptions {
    AutoNumber alpha{-1.0};
    double beta = -1;
    std::optional<double> sigma;
    std::optional<Tolerance> tolerance;
    FairEngine engine = FairEngine::gauss_newton;
    int sweeps = 250;
    int window = 9;
    FairSpacing spacing = FairSpacing::equal;
    bool split = false;
    std::optional<double> lambda;
    FixEnds fix_ends = FixEnds::none;
    bool closed = false;
    FairForm as = FairForm::points;
};

template <class Options, class Visit>
requires std::same_as<std::remove_const_t<Options>, FairOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("alpha", o.alpha, between(-20, 20),
          "kind of curve to draw the points to: -1 curvature linear in arc length, 0 Nielsen's and "
          "1 logarithmic spirals, 2 circle involutes; auto: the most likely one");
    visit("beta", o.beta, between(-20, 20), "the same for torsion (points in space)");
    visit("sigma", o.sigma, more_than(0),
          "standard deviation of the noise in each coordinate; without it estimated");
    visit("tolerance", o.tolerance, more_than(0), "no point is moved further than this");
    visit("engine", o.engine, anything, "how the points are made fair");
    visit("sweeps", o.sweeps, between(1, 1e6), "passes over the points (engine filter)");
    visit("window", o.window, between(1, 1e4), "samples on each side (engine filter)");
    visit("spacing", o.spacing, anything,
          "where a point goes between its neighbours (engine filter)");
    visit("split", o.split, anything,
          "inflections and extrema of curvature stay where they are (engine filter)");
    visit("lambda", o.lambda, more_than(0),
          "weight of fairness, in data units to the fifth power; without it found (engine "
          "gauss-newton)");
    visit("fix_ends", o.fix_ends, anything, "what stays at the two ends");
    visit("closed", o.closed, anything, "go on from the last point to the first");
    visit("as", o.as, anything, "what comes out");
}

}  // namespace batten
