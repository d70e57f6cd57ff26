#pragma once

#include <memory>
#include <string>
#include <vector>

#include "batten/make/fit_report.hpp"
#include "make/fit/covariance.hpp"
#include "make/fit/growth.hpp"
#include "make/fit/robust.hpp"

/// Knots one at a time, and where to stop.
namespace batten::fitting {

struct Path {
    std::vector<FitStep> steps;
    std::vector<std::vector<double>> breaks;  ///< of every step
    std::size_t chosen = 0;
    bool is_met = true;              ///< the rule was fulfilled
    std::vector<Alternative> alternatives;  ///< where a criterion chose: what it might have chosen
    std::vector<std::string> notes;  ///< ties
};

/// What decides on the number of intervals.
struct StopPlan {
    StopRule rule = StopRule::bic;
    Psi phi{};
    int exactly = 0;         ///< so many intervals whatever the rule, 0: the rule decides
    double delta2 = 0;       ///< stop below this, 0: not asked
    bool wants_psi = false;  ///< list psi of every step
};

/// All the numbers of a step.
FitStep step_of(double delta2, std::size_t samples, int parameters, int intervals,
                SigmaKnowledge knowledge);

/// Inserts knots in the middle of the interval with the largest part sum (KPROG = 2).
///
/// The criteria search on to max(45, 2 x the best so far) intervals, or until nothing can be
/// split, or p exceeds half the samples (but for bic with sigma known).
Path insert_one_by_one(Growth& growth, const Samples& samples, Robust robust,
                       const StopPlan& plan);
/// The same with intervals of equal length.
Path equal_intervals(Growth& growth, const Samples& samples, Robust robust, const StopPlan& plan);

/// What is left of the samples by the last refit: see residuals_of in residuals.hpp.
std::vector<double> residuals_of(const Growth& growth, const Samples& samples);

/// The weights that the residuals of the last refit asked for.
struct RobustWeights {
    std::vector<double> factors;        ///< of sigma; empty: all 1
    std::unique_ptr<Samples> samples;   ///< with these weights; null: as they are
};

/// Refits `growth`, weights decided by the residuals up to four times. Returns the misfit for the
/// criteria: delta2, or the robust loss.
double robust_refit(Growth& growth, const Samples& samples, Robust robust,
                    RobustWeights& weights);

}  // namespace batten::fitting
