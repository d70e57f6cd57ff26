#include "make/fit/curve_search.hpp"

#include <algorithm>
#include <cmath>

#include "make/fit/fixed_curve.hpp"
#include "make/fit/free_choice.hpp"
#include "make/fit/pruned_choice.hpp"
#include "make/fit/tolerance_choice.hpp"

namespace batten::fitting {
namespace {

constexpr double misfit_gain_enough = 1e-4;  // of the misfit, to correct the parameters once more

bool has_dropped(const std::vector<double>& factors) {
    return std::any_of(factors.begin(), factors.end(), [](double f) { return std::isinf(f); });
}

}  // namespace

CurveSearch::CurveSearch(PointsView points, std::span<const double> sigma,
                         const FitOptions& options)
    : options_(options),
      problem_(points, sigma, options),
      ends_(curve_ends(points, options)),
      basis_(options.degree + 1) {}

void CurveSearch::run() {
    if (options_.tolerance) run_within_tolerance();
    else run_by_criterion();
    if (here_->fixed.undetermined.empty()) problem_.settle(curve_of(here_->fixed), here_->factors);
}

void CurveSearch::run_by_criterion() {
    // Free knots take long to find: parameters are corrected over inserted ones first.
    FitOptions first = options_;
    const bool is_free = options_.knots == KnotPlacement::free;
    if (is_free) first = by_insertion(options_);
    choose(first);
    const bool is_again = is_free || (choice_.by_data && options_.corrections > 0);
    if (placement_of(options_) != KnotPlacement::given && has_dropped(here_->factors)) {
        // Chords to an outlier and back are no length of the curve.
        problem_.measure_chords(here_->factors);
        choose(first);
    }
    if (is_again) choose(options_);
    if (choice_.moved > 0) move_on();
    if (options_.knots == KnotPlacement::pruned) {
        const BrokenSites sites = sites_of(here_->fixed.knots, problem_.samples().range);
        note_breaks(choice_, sites, basis_.order());
    }
}

/// Knots and parameters in turn, as many knots as there are.
void CurveSearch::move_on() {
    for (int round = 0; round < options_.corrections; ++round) {
        const WeightedFit before = *here_;
        Places places = problem_.places();
        WeightedFit next = weighted_fit(
            moved_on(used(), basis_, here_->fixed.knots, options_), here_->factors);
        if (!next.fixed.undetermined.empty()) break;
        here_ = std::move(next);
        correct();
        if (!(here_->misfit < before.misfit)) {
            here_ = before;
            problem_.restore(std::move(places));
            break;
        }
        if (before.misfit - here_->misfit <= misfit_gain_enough * before.misfit) break;
    }
}

void CurveSearch::choose(const FitOptions& options) {
    choice_ = choose_knots(problem_.samples(), basis_, options);
    std::vector<double> factors = here_ ? std::move(here_->factors) : std::vector<double>();
    here_ = weighted_fit(choice_.knots, std::move(factors));
    correct();
}

/// Knots for the parameters, parameters for the knots, as long as fewer will do. No correction comes
/// last: it would lower the sum of squares and might raise the largest distance.
void CurveSearch::run_within_tolerance() {
    choice_ = knots_within_tolerance();
    here_ = weighted_fit(choice_.knots, {});
    for (int round = 0; round < options_.corrections; ++round) {
        const WeightedFit before = *here_;
        Places places = problem_.places();
        correct();
        KnotChoice next = knots_within_tolerance();
        const bool is_better = next.is_met && (!choice_.is_met ||
                                               next.knots.size() < before.fixed.knots.size());
        if (!is_better) {
            here_ = before;
            problem_.restore(std::move(places));
            return;
        }
        choice_ = std::move(next);
        here_ = weighted_fit(choice_.knots, {});
    }
}

KnotChoice CurveSearch::knots_within_tolerance() const {
    const Samples samples = problem_.samples();
    require_enough(samples.size(), static_cast<std::size_t>(basis_.order()));
    return knots_within(samples, basis_, options_,
                        [&](FixedFit& fixed) {
                            return hold_ends(fixed, ends_, static_cast<int>(samples.directions()));
                        });
}

std::vector<SplineFunction> CurveSearch::curve() const {
    return splines_of(here_->fixed, problem_.samples().sides.size());
}

Samples CurveSearch::used() const {
    return here_->factors.empty() ? problem_.samples()
                                  : reweighted(problem_.samples(), here_->factors);
}

WeightedFit CurveSearch::solved(const Samples& samples, const std::vector<double>& knots,
                                std::vector<double> factors) const {
    const Ends ends = ends_of(options_);
    WeightedFit fit{factors.empty()
                        ? solve_fixed(samples, knots, basis_, ends)
                        : solve_fixed(reweighted(samples, factors), knots, basis_, ends),
                    std::move(factors)};
    fit.keeps_ends = hold_ends(fit.fixed, ends_, static_cast<int>(samples.directions()));
    return fit;
}

WeightedFit CurveSearch::weighted_fit(const std::vector<double>& knots,
                                      std::vector<double> factors) const {
    const Samples samples = problem_.samples();
    const std::size_t dim = samples.sides.size();
    WeightedFit fit = solved(samples, knots, std::move(factors));
    for (int round = 0; round < most_reweightings && options_.robust != Robust::none; ++round) {
        std::vector<double> next = robust_factors(
            options_.robust, samples, residuals_of(samples, splines_of(fit.fixed, dim)));
        if (next == fit.factors) break;
        WeightedFit again = solved(samples, knots, std::move(next));
        if (!again.fixed.undetermined.empty()) break;
        fit = std::move(again);
    }
    const std::vector<SplineFunction> curve = splines_of(fit.fixed, dim);
    fit.misfit = options_.robust == Robust::none
                     ? delta2_of(samples, residuals_of(samples, curve))
                     : robust_loss(options_.robust, samples, residuals_of(samples, curve));
    return fit;
}

/// The best of the fits met while parameters are corrected, knots as they are.
void CurveSearch::correct() {
    for (int round = 0; round < options_.corrections && here_->fixed.undetermined.empty();
         ++round) {
        Places before = problem_.places();
        problem_.correct(curve(), here_->factors);
        problem_.samples().work.step();
        WeightedFit next = weighted_fit(here_->fixed.knots, here_->factors);
        if (!next.fixed.undetermined.empty() || !(next.misfit < here_->misfit)) {
            problem_.restore(std::move(before));
            break;
        }
        const bool is_enough = here_->misfit - next.misfit <= misfit_gain_enough * here_->misfit;
        here_ = std::move(next);
        if (is_enough) break;
    }
}

}  // namespace batten::fitting
