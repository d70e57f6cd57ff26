#pragma once

#include <optional>
#include <vector>

#include "make/fit/curve_ends.hpp"
#include "make/fit/curve_problem.hpp"
#include "make/fit/knot_choice.hpp"
#include "make/fit/residuals.hpp"

/// Knots and parameters of a curve, in turn.
namespace batten::fitting {

/// A fit over given knots and parameters, weights decided by its own distances where asked.
struct WeightedFit {
    FixedFit fixed;
    std::vector<double> factors;  ///< of sigma, one a point; empty: all 1
    double misfit = 0;            ///< delta2, or the robust loss
    bool keeps_ends = true;
};

class CurveSearch {
public:
    CurveSearch(PointsView points, std::span<const double> sigma, const FitOptions& options);

    /// To be called once; what follows is its result.
    void run();

    const CurveProblem& problem() const { return problem_; }
    const WeightedFit& result() const { return *here_; }
    KnotChoice& choice() { return choice_; }
    std::vector<SplineFunction> curve() const;
    /// Whether what the ends are to keep could be kept.
    bool keeps_ends() const { return here_->keeps_ends && goes_along(curve(), ends_); }
    /// The samples with the weights of the last fit.
    Samples used() const;

private:
    void choose(const FitOptions& options);
    void run_by_criterion();
    void run_within_tolerance();
    void correct();
    void move_on();
    KnotChoice knots_within_tolerance() const;
    WeightedFit solved(const Samples& samples, const std::vector<double>& knots,
                       std::vector<double> factors) const;
    WeightedFit weighted_fit(const std::vector<double>& knots, std::vector<double> factors) const;

    const FitOptions& options_;
    CurveProblem problem_;
    CurveEnds ends_;
    LocalBasis basis_;
    KnotChoice choice_;
    std::optional<WeightedFit> here_;
};

}  // namespace batten::fitting
