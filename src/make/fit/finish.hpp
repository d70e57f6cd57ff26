#pragma once

#include "batten/make/fit.hpp"
#include "make/fit/covariance.hpp"
#include "make/fit/fixed_fit.hpp"
#include "make/fit/tally.hpp"

/// From a solved problem to the report: the same for every kind of fit.
namespace batten::fitting {

/// delta2 and the count of samples and parameters, and all numbers that follow from these.
struct Misfit {
    double delta2 = 0;
    std::size_t samples = 0;
    SigmaKnowledge knowledge = SigmaKnowledge::known;
    int directions = 1;  ///< in which a coefficient counts as a parameter, see Samples
    double least = 0;  ///< less than this is rounding, and no better
};
void fill_criteria(FitReport& report, const FixedFit& fixed, const Misfit& misfit);

/// What only residuals say.
void fill_tally(FitReport& report, const ResidualTally& tally);

/// Knots, breaks and coefficients.
void fill_spline(FitReport& report, const SplineFunction& spline);

/// A note where samples leave coefficients open.
void note_open_coefficients(FitReport& report);

/// A note where coefficients are more than two thirds of the samples.
void note_many_coefficients(FitReport& report);

/// A note where errors were estimated and residuals are of another size: three times more or less.
void note_what_sigma_hides(FitReport& report);

/// A note where errors are known and more is left than they would leave: chi2_p below 1e-6.
void note_large_residuals(FitReport& report);

/// The 95 % band at 201 abscissae.
void fill_band(FitReport& report, const SplineFunction& spline, const FitCovariance& covariance);

}  // namespace batten::fitting
