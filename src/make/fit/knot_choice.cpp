#include "make/fit/knot_choice.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit/fixed_fit.hpp"
#include "make/fit/free_choice.hpp"
#include "make/fit/held.hpp"
#include "make/fit/pruned_choice.hpp"
#include "make/fit/residuals.hpp"
#include "make/fit/shape_limits.hpp"
#include "make/fit/tolerance_choice.hpp"

namespace batten::fitting {
namespace {

constexpr int most_rounds = 4;
constexpr std::size_t most_with_psi = 20000;

[[noreturn]] void refuse(const char* option, std::string value, std::string rule) {
    throw Error("fit.options", option, std::move(value), std::move(rule));
}

/// What the last refit solved, if it is the fit over `breaks` and determined.
std::optional<FixedFit> last_fit(const Growth& growth, const std::vector<double>& breaks) {
    const bool is_it = growth.ends() == Ends::open && growth.is_determined() &&
                       growth.breaks() == breaks;
    if (!is_it) return std::nullopt;
    const int functions = growth.functions();
    return FixedFit{growth.knots(), growth.system(), functions, functions, {}, {}, {}, 0};
}

KnotChoice from_path(const Growth& growth, Path path) {
    KnotChoice choice;
    const std::vector<double>& breaks = path.breaks[path.chosen];
    choice.solved = last_fit(growth, breaks);
    const int order = growth.system().order();
    choice.knots = growth.ends() == Ends::closed
                       ? closed_knots(breaks, order)
                       : open_knots({breaks.front(), breaks.back()},
                                    {breaks.data() + 1, breaks.size() - 2}, order);
    choice.path = std::move(path.steps);
    choice.notes = std::move(path.notes);
    choice.alternatives = std::move(path.alternatives);
    choice.is_met = path.is_met;
    choice.by_data = true;
    return choice;
}

KnotChoice given_knots(const Samples& samples, const FitOptions& options) {
    const int order = options.degree + 1;
    const std::vector<double> inner = inner_knots(options.knots_values, samples.range);
    require_inner_knots(inner, samples.range, options.degree);
    KnotChoice choice;
    if (options.closed) {
        std::vector<double> breaks{samples.range.lo};
        breaks.insert(breaks.end(), inner.begin(), inner.end());
        breaks.push_back(samples.range.hi);
        for (std::size_t i = 1; i < breaks.size(); ++i) {
            if (breaks[i] > breaks[i - 1]) continue;
            throw Error("fit.knots", "knot " + std::to_string(i), format_number(breaks[i]),
                        "the knots of a closed spline must be simple");
        }
        require_enough(samples.size(), breaks.size() - 1);
        choice.knots = closed_knots(breaks, order);
    } else {
        require_enough(samples.size(), inner.size() + static_cast<std::size_t>(order));
        choice.knots = open_knots(samples.range, inner, order);
    }
    return choice;
}

KnotChoice equal_knots(const Samples& samples, const LocalBasis& basis, const FitOptions& options) {
    const std::size_t order = static_cast<std::size_t>(basis.order());
    if (options.intervals) {
        const std::size_t n = static_cast<std::size_t>(*options.intervals);
        require_enough(samples.size(), options.closed ? n : n + order - 1);
        const std::vector<double> breaks = equal_breaks(samples.range, n);
        KnotChoice choice;
        choice.knots = options.closed
                           ? closed_knots(breaks, basis.order())
                           : open_knots(samples.range, {breaks.data() + 1, n - 1}, basis.order());
        return choice;
    }
    require_enough(samples.size(), options.closed ? 1 : order);
    Growth growth(samples, basis, ends_of(options), samples.range);
    return from_path(growth, equal_intervals(growth, samples, options.robust,
                                             stop_plan(samples, options)));
}

KnotChoice inserted_knots(const Samples& samples, const LocalBasis& basis,
                          const FitOptions& options) {
    require_enough(samples.size(), options.closed ? 1 : static_cast<std::size_t>(basis.order()));
    Growth growth(samples, basis, ends_of(options), samples.range);
    return from_path(growth, insert_one_by_one(growth, samples, options.robust,
                                               stop_plan(samples, options)));
}

/// What the residuals of a choice's robust fit make of the weights.
std::vector<double> chosen_factors(const Samples& samples, const LocalBasis& basis,
                                   const KnotChoice& choice, const FitOptions& options) {
    const Interval domain = samples.range;
    std::vector<double> breaks{domain.lo};
    for (const double t : choice.knots) {
        if (t > domain.lo && t < domain.hi) breaks.push_back(t);
    }
    breaks.push_back(domain.hi);
    Growth growth(samples, basis, ends_of(options), domain);
    growth.restart(breaks);
    RobustWeights weights;
    robust_refit(growth, samples, options.robust, weights);
    return robust_factors(options.robust, samples, residuals_of(growth, samples));
}

/// The same for a choice over `weighted` samples, all samples judged by it.
std::vector<double> factors_over(const Samples& samples, const Samples& weighted,
                                 const LocalBasis& basis, const KnotChoice& choice,
                                 const FitOptions& options) {
    FixedFit fixed = solve_fixed(weighted, choice.knots, basis, ends_of(options));
    hold_smooth(fixed, choice.held);
    return robust_factors(options.robust, samples,
                          residuals_of(samples, splines_of(fixed, samples.sides.size())));
}

KnotChoice freed_knots(const Samples& samples, const LocalBasis& basis,
                       const FitOptions& options) {
    require_enough(samples.size(), options.closed ? 1 : static_cast<std::size_t>(basis.order()));
    const auto chosen = [&](const Samples& used) {
        return options.knots == KnotPlacement::pruned ? pruned_knots(used, basis, options)
                                                      : free_knots(used, basis, options);
    };
    if (options.robust == Robust::none) return chosen(samples);
    // The outliers are those of the inserted knots; the last refit decides again.
    std::vector<double> factors = chosen_factors(
        samples, basis, inserted_knots(samples, basis, by_insertion(options)), options);
    KnotChoice choice = chosen(reweighted(samples, factors));
    // Beside a jump inserted knots miss good samples too: those are asked back.
    for (int round = 0; round < most_rounds && options.knots == KnotPlacement::pruned; ++round) {
        std::vector<double> next =
            factors_over(samples, reweighted(samples, factors), basis, choice, options);
        if (next == factors) break;
        factors = std::move(next);
        choice = chosen(reweighted(samples, factors));
    }
    return choice;
}

}  // namespace

std::vector<double> inner_knots(std::span<const double> values, Interval range) {
    while (!values.empty() && values.front() == range.lo) values = values.subspan(1);
    while (!values.empty() && values.back() == range.hi) values = values.first(values.size() - 1);
    return {values.begin(), values.end()};
}

void require_inner_knots(std::span<const double> values, Interval range, int degree) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string place = "knot " + std::to_string(i + 1);
        if (!(values[i] > range.lo && values[i] < range.hi)) {
            throw Error("fit.knots", place, format_number(values[i]),
                        "interior knots must lie between the first and the last abscissa");
        }
        if (i > 0 && values[i] < values[i - 1]) {
            throw Error("fit.knots", place, format_number(values[i]), "knots must not decrease");
        }
        const std::size_t most = static_cast<std::size_t>(degree) + 1;
        if (i >= most && values[i] == values[i - most]) {
            throw Error("fit.knots", place, format_number(values[i]),
                        "a knot may be repeated degree + 1 times at most");
        }
    }
}

void require_enough(std::size_t samples, std::size_t functions) {
    if (samples >= functions) return;
    throw Error("fit.too-few", "samples", std::to_string(samples),
                "there must be at least as many as coefficients, " + std::to_string(functions));
}

void require_options(const FitOptions& o) {
    require_limits(o);
    if (o.degree < 0 || o.degree > 9) {
        throw Error("option.range", "degree", std::to_string(o.degree), "must be 0 to 9");
    }
    if (o.intervals && *o.intervals < 1) {
        throw Error("fit.intervals", "intervals", std::to_string(*o.intervals),
                    "there must be at least one");
    }
    const KnotPlacement placement = placement_of(o);
    if (!o.knots_values.empty() && placement != KnotPlacement::given) {
        refuse("knots_values", "given", "knots are " + std::string(name_of(o.knots)) + ", not listed");
    }
    if (placement == KnotPlacement::given && o.intervals) {
        refuse("intervals", std::to_string(*o.intervals), "do not go with given knots");
    }
    if (placement == KnotPlacement::given && o.delta2) {
        refuse("delta2", format_number(*o.delta2), "does not go with given knots");
    }
    if (o.intervals && o.delta2) {
        refuse("intervals", std::to_string(*o.intervals), "and delta2 exclude each other");
    }
    if (o.stop == StopRule::none && !o.intervals && !o.delta2 &&
        placement != KnotPlacement::given) {
        refuse("stop", "none", "needs the number of intervals");
    }
    if (o.stop != StopRule::distribution && !o.distribution.empty()) {
        refuse("distribution", "given", "goes with the stopping rule distribution only");
    }
    if (o.tolerance && !(o.tolerance->value > 0)) {
        throw Error("option.range", "tolerance", format_number(o.tolerance->value),
                    "must be above 0");
    }
    if (o.tolerance && (placement != KnotPlacement::automatic || o.intervals || o.delta2 ||
                        o.robust != Robust::none)) {
        refuse("tolerance", format_number(o.tolerance->value),
               "chooses the knots itself, by all samples");
    }
    if (o.free_from && o.knots != KnotPlacement::free) {
        refuse("free_from", format_number(*o.free_from), "goes with free knots only");
    }
    if (o.knots == KnotPlacement::free && o.degree == 0) {
        refuse("degree", "0", "free knots need degree 1 or more: a jump has no derivative");
    }
    if (o.knots == KnotPlacement::pruned && (o.intervals || o.delta2)) {
        refuse("knots", "pruned", "chooses the number of intervals itself");
    }
    for (const std::optional<double>& target : {o.delta2, o.free_from}) {
        if (!target || *target > 0) continue;
        throw Error("option.range", "delta2, free_from", format_number(*target),
                    "must be above 0");
    }
}

FitOptions by_insertion(const FitOptions& options) {
    FitOptions insertion = options;
    insertion.knots = KnotPlacement::automatic;
    insertion.stop = StopRule::bic;
    insertion.distribution.clear();
    insertion.intervals.reset();
    return insertion;
}

StopPlan stop_plan(const Samples& samples, const FitOptions& options) {
    StopPlan plan;
    plan.rule = options.stop;
    plan.phi = error_distribution(options.distribution);
    plan.exactly = options.intervals.value_or(0);
    plan.delta2 = options.delta2.value_or(0);
    plan.wants_psi = samples.size() <= most_with_psi;
    return plan;
}

KnotChoice choose_knots(const Samples& samples, const LocalBasis& basis,
                        const FitOptions& options) {
    if (options.tolerance) {
        require_enough(samples.size(), static_cast<std::size_t>(basis.order()));
        return knots_within(samples, basis, options, [&options](FixedFit& fixed) {
            return !has_limits(options) || keep_within_limits(fixed, options);
        });
    }
    switch (placement_of(options)) {
        case KnotPlacement::given: return given_knots(samples, options);
        case KnotPlacement::equal: return equal_knots(samples, basis, options);
        case KnotPlacement::automatic: break;
        case KnotPlacement::pruned:
        case KnotPlacement::free: return freed_knots(samples, basis, options);
    }
    return inserted_knots(samples, basis, options);
}

}  // namespace batten::fitting
