#include "make/fit/free_choice.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "make/fit/exchange.hpp"
#include "make/fit/residuals.hpp"
#include "make/fit/tally.hpp"

namespace batten::fitting {
namespace {

constexpr int refined = 6;
constexpr int levenberg_steps = 60;
/// So many knots more without a better criterion end the search.
constexpr int patience = 5;

SigmaKnowledge knowledge_of(const Samples& samples) {
    return samples.sigma_known ? SigmaKnowledge::known : SigmaKnowledge::unknown;
}

/// Sets of knots tried, and the rule's opinion of them.
class FreeSearch {
public:
    FreeSearch(FreeFit& fit, const LocalBasis& basis, const Samples& samples, const StopPlan& plan,
               Ends ends)
        : fit_(fit), basis_(basis), samples_(samples), plan_(plan), ends_(ends) {}

    /// Records; whether more knots are wanted. `moved`: the knots were optimised.
    bool wants_more(const Descent& d, bool moved) {
        const int p = fit_.parameters_of(d.set);
        const double delta2 = delta2_of(d);
        const double least = std::max(delta2, samples_.least_delta2);
        FitStep step = step_of(least, samples_.values(), p, d.set.count() + 1, knowledge_of(samples_));
        const FitStep charged =
            step_of(least, samples_.values(), moved ? p + d.set.count() : p, step.intervals,
                    knowledge_of(samples_));
        step.delta2 = delta2;
        step.parameters_charged = charged.parameters_charged;
        if (plan_.rule == StopRule::distribution ||
            (plan_.wants_psi && samples_.sides.size() == 1)) {
            const FixedFit fixed =
                solve_fixed(samples_, fit_.knots_of(d.set), basis_, ends_);
            const Psi psi = tally(samples_, spline_of(fixed)).psi;
            step.psi.assign(psi.begin(), psi.end());
        }
        choice_.path.push_back(step);
        return judge(d, charged, p, moved);
    }

    KnotChoice finish() {
        choice_.knots = fit_.knots_of(best_.set);
        choice_.moved = best_moved_ ? best_.set.count() : 0;
        choice_.by_data = true;
        choice_.is_converged = best_.is_converged;
        if (best_moved_ && is_singular(fit_, best_.set)) {
            choice_.notes.push_back("knots: not unique, some can move without changing delta2");
        }
        const std::string last = std::to_string(choice_.path.back().intervals);
        if (!choice_.is_met) {
            choice_.notes.push_back("intervals: the samples determine no more than " + last);
        } else if (is_capped_ && since_best_ == 0) {
            choice_.notes.push_back("intervals: the criterion was still falling at " + last +
                                    ", where parameters are half as many as samples");
        }
        return std::move(choice_);
    }

private:
    /// Also where the samples leave coefficients open.
    double delta2_of(const Descent& d) const {
        if (std::isfinite(d.delta2)) return d.delta2;
        const FixedFit fixed = solve_fixed(samples_, fit_.knots_of(d.set), basis_, ends_);
        return fitting::delta2_of(
            samples_, residuals_of(samples_, splines_of(fixed, samples_.sides.size())));
    }

    bool judge(const Descent& d, const FitStep& charged, int p, bool moved) {
        const FitStep& step = choice_.path.back();
        const bool is_first = choice_.path.size() == 1;
        bool is_end = false, is_better = true;
        if (plan_.exactly > 0) {
            is_end = d.set.count() + 1 >= plan_.exactly;
            choice_.is_met = d.set.count() + 1 == plan_.exactly;
        } else if (plan_.delta2 > 0) {
            choice_.is_met = is_end = step.delta2 <= plan_.delta2;
        } else if (plan_.rule == StopRule::distribution) {
            choice_.is_met = is_end = is_distributed(step.psi, plan_.phi);
        } else if (plan_.rule == StopRule::chi2) {
            const double degrees = static_cast<double>(samples_.values()) - p;
            choice_.is_met = is_end =
                degrees > 0 && step.delta2 <= chi2_quantile(0.05, degrees);
        } else {
            const double value = criterion_of(charged, plan_.rule);
            is_better = is_first || value < least_;
            if (is_better) least_ = value;
            since_best_ = is_better ? 0 : since_best_ + 1;
            is_capped_ = 2 * (p + d.set.count()) > samples_size();
            is_end = since_best_ >= patience || is_capped_;
        }
        if (is_better) {
            best_ = d;
            best_moved_ = moved;
        }
        return !is_end;
    }
    int samples_size() const { return static_cast<int>(samples_.values()); }

    FreeFit& fit_;
    const LocalBasis& basis_;
    const Samples& samples_;
    const StopPlan& plan_;
    Ends ends_;
    KnotChoice choice_;
    Descent best_;
    bool best_moved_ = false;
    double least_ = 0;
    int since_best_ = 0;
    bool is_capped_ = false;
};

/// The best set of one knot more; false where no knot can be put in.
bool grow(FreeFit& fit, Descent& here) {
    const int before = here.set.count();
    Descent next = with_one_more(fit, here.set, refined);
    if (next.set.count() == before) return false;
    next = newton_descent(fit, next.set, levenberg_steps);
    here = exchange(fit, std::move(next));
    return true;
}

KnotChoice grown(FreeFit& fit, FreeSearch& search) {
    Descent here{KnotSet{}, fit.value(KnotSet{}), 0, true};
    while (search.wants_more(here, true) && grow(fit, here)) continue;
    return search.finish();
}

KnotSet halved(FreeFit& fit, const KnotSet& set) {
    // The paper's insertion: the middle of the gap with the largest part sum.
    fit.value(set);
    const std::vector<double> sums = fit.part_sums();
    std::vector<std::size_t> order(sums.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sums[a] > sums[b]; });
    for (const std::size_t gap : order) {
        const double lo = gap == 0 ? fit.domain().lo : set.at[gap - 1];
        const double hi = gap == set.size() ? fit.domain().hi : set.at[gap];
        KnotSet more = set;
        more.at.insert(more.at.begin() + static_cast<std::ptrdiff_t>(gap),
                       knot_between({lo, hi}));
        more.times.insert(more.times.begin() + static_cast<std::ptrdiff_t>(gap), 1);
        if (std::isfinite(fit.value(more))) return more;
    }
    return set;
}

KnotChoice moved_part_way(FreeFit& fit, FreeSearch& search, double free_from) {
    Descent here{KnotSet{}, fit.value(KnotSet{}), 0, true};
    bool moves = here.delta2 < free_from;
    while (search.wants_more(here, moves)) {
        const KnotSet more = halved(fit, here.set);
        if (more.count() == here.set.count()) break;
        moves = moves || fit.value(more) < free_from;
        if (moves) {
            here = newton_descent(fit, more, levenberg_steps);
        } else {
            here = {more, fit.value(more), 0, true};
        }
    }
    return search.finish();
}

}  // namespace

KnotChoice free_knots(const Samples& samples, const LocalBasis& basis, const FitOptions& options) {
    const Ends ends = ends_of(options);
    FreeFit fit(samples, basis, ends);
    const StopPlan plan = stop_plan(samples, options);
    FreeSearch search(fit, basis, samples, plan, ends);
    return options.free_from ? moved_part_way(fit, search, *options.free_from)
                             : grown(fit, search);
}

std::optional<KnotSet> fewest_free(FreeFit& fit, int most,
                                   const std::function<bool(const KnotSet&)>& is_accepted) {
    Descent here{KnotSet{}, fit.value(KnotSet{}), 0, true};
    while (!is_accepted(here.set)) {
        if (here.set.count() >= most || !grow(fit, here)) return std::nullopt;
    }
    return here.set;
}

std::vector<double> moved_on(const Samples& samples, const LocalBasis& basis,
                             const std::vector<double>& knots, const FitOptions& options) {
    FreeFit fit(samples, basis, ends_of(options));
    return fit.knots_of(
        newton_descent(fit, KnotSet::of(knots, samples.range), levenberg_steps).set);
}

}  // namespace batten::fitting
