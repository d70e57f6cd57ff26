#include "make/fit/path.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "batten/base/text.hpp"
#include "batten/shape/spline_function.hpp"
#include "make/fit/residuals.hpp"
#include "make/fit/spare_knots.hpp"

namespace batten::fitting {
namespace {

constexpr int least_reach = 45;   // intervals, see docs/fitting.md
/// What a parameter costs an alternative: by coverage on the five functions of the tests bic's ln N
/// is too sure of the knots (76 to 96 %), Akaike's 2 sometimes too unsure (94 to 98 %).
constexpr double charge = 2.25;
constexpr double least_weight = 0.01;  // of the best alternative's: less is left out
constexpr double tie = 1e-9;      // relative difference of two criteria that is none

SplineFunction spline_of(const Growth& growth, std::size_t side = 0) {
    const std::span<const double> c = growth.system().coefficients(static_cast<int>(side));
    std::vector<double> values(c.begin(), c.end());
    const int degree = growth.system().order() - 1;
    return growth.ends() == Ends::closed
               ? SplineFunction::periodic(growth.knots(), std::move(values), degree)
               : SplineFunction(growth.knots(), std::move(values), degree);
}

int functions_over(int intervals, const Growth& growth) {
    return growth.ends() == Ends::closed ? intervals : intervals + growth.system().order() - 1;
}

/// One search: which steps there were and whether to go on.
class Search {
public:
    Search(Growth& growth, const Samples& samples, Robust robust, const StopPlan& plan)
        : growth_(growth), samples_(samples), robust_(robust), plan_(plan) {}

    /// Refits and records a step. Whether more intervals are wanted.
    bool step_wants_more() {
        const double misfit = robust_refit(growth_, samples_, robust_, weights_);
        const SigmaKnowledge knowledge =
            samples_.sigma_known ? SigmaKnowledge::known : SigmaKnowledge::unknown;
        samples_.work.step();
        FitStep step = step_of(std::max(misfit, samples_.least_delta2), samples_.values(),
                               parameters(), growth_.intervals(), knowledge);
        step.delta2 = misfit;
        if ((plan_.wants_psi && samples_.sides.size() == 1) || plan_.rule == StopRule::distribution) {
            const Psi psi = tally(samples_, residuals_of(growth_, samples_)).psi;
            step.psi.assign(psi.begin(), psi.end());
        }
        path_.steps.push_back(step);
        path_.breaks.push_back(growth_.breaks());
        return wants_more(step);
    }

    /// Remembers that the worst interval, to be halved next, fits as badly as another one.
    void see_tie(int worst) {
        const double largest = growth_.part_sum(worst);
        if (!(growth_.delta2() > samples_.least_delta2)) return;
        for (int i = 0; i < growth_.intervals(); ++i) {
            const bool is_as_bad = i != worst && largest - growth_.part_sum(i) <= tie * largest;
            if (!is_as_bad || !growth_.can_split(i)) continue;
            ties_.push_back({path_.steps.size() - 1, growth_.span(worst), growth_.span(i)});
            return;
        }
    }

    Path finish() {
        choose();
        tell_ties();
        tell_why_it_ended();
        const bool is_chosen_freely = plan_.exactly == 0 && plan_.delta2 == 0;
        const bool has_bands = samples_.sides.size() == 1;
        if (has_bands && is_chosen_freely && is_criterion(plan_.rule)) weigh_alternatives();
        return std::move(path_);
    }

private:
    int parameters() const {
        return growth_.functions() * static_cast<int>(samples_.directions());
    }

    bool wants_more(const FitStep& step) {
        if (plan_.exactly > 0) {
            is_met_ = step.intervals == plan_.exactly;
            return !is_met_;
        }
        if (plan_.delta2 > 0) is_met_ = step.delta2 <= plan_.delta2;
        else if (plan_.rule == StopRule::distribution) is_met_ = is_distributed(step.psi, plan_.phi);
        else if (plan_.rule == StopRule::chi2) is_met_ = is_within_chi2(step);
        else return reaches_on(step);
        return !is_met_;
    }

    bool is_within_chi2(const FitStep& step) const {
        const double degrees =
            static_cast<double>(samples_.values()) - static_cast<double>(parameters());
        return degrees > 0 && step.delta2 <= chi2_quantile(0.05, degrees);
    }

    bool reaches_on(const FitStep& step) {
        const double value = criterion_of(step, plan_.rule);
        if (path_.steps.size() == 1 || value < best_) {
            best_ = value;
            best_intervals_ = step.intervals;
        }
        is_met_ = true;
        // Where delta2 enters by its logarithm, interpolation would always win.
        const bool is_bounded = plan_.rule == StopRule::bic && samples_.sigma_known;
        const std::size_t twice = 2 * static_cast<std::size_t>(growth_.functions() + 1);
        is_capped_ = !is_bounded && twice > samples_.size();
        if (is_capped_) return false;
        return step.intervals < std::max(least_reach, 2 * best_intervals_);
    }

    void choose() {
        path_.is_met = is_met_;
        path_.chosen = path_.steps.size() - 1;
        if (plan_.exactly > 0 || plan_.delta2 > 0 || !is_criterion(plan_.rule)) return;
        for (std::size_t i = path_.steps.size(); i-- > 0;) {
            if (criterion_of(path_.steps[i], plan_.rule) <=
                criterion_of(path_.steps[path_.chosen], plan_.rule)) {
                path_.chosen = i;
            }
        }
        const double least = criterion_of(path_.steps[path_.chosen], plan_.rule);
        for (std::size_t i = 0; i < path_.steps.size(); ++i) {
            const double other = criterion_of(path_.steps[i], plan_.rule);
            if (i == path_.chosen || std::fabs(other - least) > tie * std::fabs(least)) continue;
            path_.notes.push_back("tie: " + std::to_string(path_.steps[i].intervals) + " and " +
                                  std::to_string(path_.steps[path_.chosen].intervals) +
                                  " intervals are equally good; the fewer are taken");
        }
    }

    /// The ties on the way to the step taken.
    void tell_ties() {
        std::size_t count = 0;
        while (count < ties_.size() && ties_[count].step < path_.chosen) ++count;
        if (count == 0) return;
        const auto text = [](Interval span) {
            return "[" + format_number(span.lo) + ", " + format_number(span.hi) + "]";
        };
        const Tie& first = ties_.front();
        path_.notes.push_back(
            "tie: with " + std::to_string(path_.steps[first.step].intervals) + " intervals " +
            text(first.halved) + " and " + text(first.other) +
            " fit equally badly; the first of them is halved" +
            (count > 1 ? ", and so in " + std::to_string(count - 1) + " later steps" : ""));
    }

    /// Where not the rule ended the search but what the samples allow.
    void tell_why_it_ended() {
        const std::string last = std::to_string(path_.steps.back().intervals);
        if (!path_.is_met) {
            path_.notes.push_back("intervals: the samples determine no more than " + last);
            return;
        }
        const bool by_criterion =
            plan_.exactly == 0 && plan_.delta2 == 0 && is_criterion(plan_.rule);
        if (!by_criterion || path_.steps.size() == 1) return;
        if (path_.chosen + 1 < path_.steps.size()) return;
        path_.notes.push_back("intervals: the criterion was still falling at " + last +
                              (is_capped_ ? ", where coefficients are half as many as samples"
                                          : ", as many as the samples determine"));
    }

    /// Weights exp(-(misfit + charge p) / 2) of all steps, those that matter refitted.
    void weigh_alternatives() {
        const double sigma2 = path_.steps[path_.chosen].sigma2.value_or(0);
        const double unit = samples_.sigma_known || !(sigma2 > 0) ? 1 : sigma2;
        std::vector<double> values;
        for (const FitStep& step : path_.steps) {
            values.push_back(step.delta2 / unit +
                             charge * functions_over(step.intervals, growth_));
        }
        const double least = *std::min_element(values.begin(), values.end());
        double sum = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double weight = std::exp(-0.5 * (values[i] - least));
            if (weight < least_weight) continue;
            growth_.restart(path_.breaks[i]);
            growth_.refit();
            path_.alternatives.push_back(
                {weight, CoefficientLaw(spline_of(growth_), growth_.system())});
            sum += weight;
        }
        for (Alternative& a : path_.alternatives) a.weight /= sum;
    }

    struct Tie {
        std::size_t step;
        Interval halved, other;
    };

    Growth& growth_;
    const Samples& samples_;
    std::vector<Tie> ties_;
    Robust robust_;
    const StopPlan& plan_;
    RobustWeights weights_;
    Path path_;
    double best_ = 0;
    int best_intervals_ = 1;
    bool is_met_ = false;
    bool is_capped_ = false;  ///< the last step has as many coefficients as are allowed
};

}  // namespace

std::vector<double> residuals_of(const Growth& growth, const Samples& samples) {
    if (&growth.samples() == &samples && samples.sides.size() == 1) {
        std::vector<double> e(samples.size());
        growth.residuals(e);
        return e;
    }
    std::vector<SplineFunction> splines;
    for (std::size_t s = 0; s < samples.sides.size(); ++s) splines.push_back(spline_of(growth, s));
    return residuals_of(samples, splines);
}

FitStep step_of(double delta2, std::size_t samples, int parameters, int intervals,
                SigmaKnowledge knowledge) {
    return {fit_criteria(delta2, samples, parameters, knowledge), intervals, parameters, {}};
}

double robust_refit(Growth& growth, const Samples& samples, Robust robust,
                    RobustWeights& weights) {
    growth.refit();
    if (robust == Robust::none) return growth.delta2();
    for (int round = 0; round < most_reweightings; ++round) {
        std::vector<double> factors = robust_factors(robust, samples, residuals_of(growth, samples));
        const bool is_plain =
            std::all_of(factors.begin(), factors.end(), [](double f) { return f == 1; });
        if (is_plain) factors.clear();
        if (factors == weights.factors) break;
        weights.factors = std::move(factors);
        auto fresh =
            is_plain ? nullptr : std::make_unique<Samples>(reweighted(samples, weights.factors));
        growth.reweigh(fresh ? *fresh : samples);
        if (!growth.can_take(growth.breaks())) {
            // Too few are left for these knots: no weights then.
            growth.reweigh(samples);
            fresh.reset();
            weights.factors.clear();
            round = most_reweightings;
        }
        weights.samples = std::move(fresh);
        growth.refit();
    }
    return robust_loss(robust, samples, residuals_of(growth, samples));
}

namespace {

/// How many of the worst intervals to halve next: as many as hold what is to go beyond a target for
/// delta2, each less its share of the target, but no more than half of all.
int splits_wanted(const Growth& growth, double target) {
    const double excess = growth.delta2() - target;
    if (!(target > 0 && excess > 0)) return 1;
    const double share = target / static_cast<double>(growth.samples().size());
    std::vector<double> excesses;
    for (int i = 0; i < growth.intervals(); ++i) {
        excesses.push_back(growth.part_sum(i) - share * static_cast<double>(growth.rows(i)));
    }
    std::sort(excesses.begin(), excesses.end(), std::greater<>());
    int count = 1;
    for (double sum = excesses[0]; sum < excess && count < 1 + growth.intervals() / 2; ++count) {
        sum += excesses[static_cast<std::size_t>(count)];
    }
    return count;
}

}  // namespace

Path insert_one_by_one(Growth& growth, const Samples& samples, Robust robust,
                       const StopPlan& plan) {
    Search search(growth, samples, robust, plan);
    while (search.step_wants_more()) {
        std::vector<int> worst = growth.worst(splits_wanted(growth, plan.delta2));
        if (worst.empty()) break;
        if (worst.size() == 1) search.see_tie(worst[0]);
        // From the right, so that no index moves; a split may take what another one needs.
        std::sort(worst.begin(), worst.end(), std::greater<>());
        for (const int i : worst) {
            if (worst.size() == 1 || growth.can_split(i)) growth.split(i);
        }
    }
    const bool may_spare = plan.delta2 > 0 && robust == Robust::none &&
                           growth.ends() == Ends::open && samples.sides.size() == 1;
    if (may_spare && take_out_spare(growth, plan.delta2)) search.step_wants_more();
    return search.finish();
}

Path equal_intervals(Growth& growth, const Samples& samples, Robust robust, const StopPlan& plan) {
    Search search(growth, samples, robust, plan);
    const Interval domain = samples.range;
    while (search.step_wants_more()) {
        const std::size_t n = static_cast<std::size_t>(growth.intervals()) + 1;
        const std::vector<double> breaks = equal_breaks(domain, n);
        if (!growth.can_take(breaks)) break;
        growth.restart(breaks);
    }
    return search.finish();
}

}  // namespace batten::fitting
