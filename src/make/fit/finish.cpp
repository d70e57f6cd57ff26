#include "make/fit/finish.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::fitting {
namespace {

constexpr int band_points = 201;

}  // namespace

void fill_criteria(FitReport& report, const FixedFit& fixed, const Misfit& misfit) {
    if (!std::isfinite(misfit.delta2)) {
        throw Error("number.overflow", "delta2", format_number(misfit.delta2),
                    "is beyond the range of a double");
    }
    const int parameters = misfit.directions * fixed.functions - fixed.fixed_count;
    static_cast<FitCriteria&>(report) = fit_criteria(std::max(misfit.delta2, misfit.least),
                                                     misfit.samples, parameters, misfit.knowledge);
    report.parameters = report.parameters_charged = parameters;
    report.rank = std::min(misfit.directions * fixed.rank, parameters);
    report.undetermined = fixed.undetermined;
    report.samples = misfit.samples;
    report.delta2 = misfit.delta2;
    const double degrees = static_cast<double>(misfit.samples) - parameters;
    if (degrees > 0) report.sigma2 = misfit.delta2 / degrees;
    if (misfit.knowledge == SigmaKnowledge::known && degrees > 0) {
        report.chi2_p = chi2_survival(misfit.delta2, degrees);
    }
    if (!report.undetermined.empty()) report.status = Status::rank_deficient;
}

void fill_tally(FitReport& report, const ResidualTally& tally) {
    report.psi.assign(tally.psi.begin(), tally.psi.end());
    report.max_residual = tally.max_residual;
    report.runs_p = runs_probability(tally.runs, tally.positive, report.samples - tally.positive);
}

void fill_spline(FitReport& report, const SplineFunction& spline) {
    // The paper's n, in which a double knot has an interval of no length.
    report.intervals = static_cast<int>(spline.coefficients().size()) - spline.degree();
    report.breaks.assign(spline.breaks().begin(), spline.breaks().end());
    report.knots.assign(spline.knots().begin(), spline.knots().end());
    report.coefficients.assign(spline.coefficients().begin(), spline.coefficients().end());
}

void note_open_coefficients(FitReport& report) {
    if (report.undetermined.empty()) return;
    report.notes.push_back(std::to_string(report.undetermined.size()) +
                           " coefficients are not determined by the samples: continued smoothly, "
                           "no band");
}

void note_many_coefficients(FitReport& report) {
    if (3 * static_cast<std::size_t>(report.parameters) <= 2 * report.samples) return;
    report.notes.push_back("coefficients: " + std::to_string(report.parameters) + " for " +
                           std::to_string(report.samples) +
                           " samples: the spline follows their errors and may swing between them");
}

void note_what_sigma_hides(FitReport& report) {
    constexpr double alike = 3;
    if (report.sigma_source != SigmaSource::estimated || !report.sigma || !report.sigma2) return;
    const double ratio = std::sqrt(*report.sigma2);
    if (ratio <= alike && ratio >= 1 / alike) return;
    report.notes.push_back("sigma: estimated from differences of neighbours as " +
                           format_brief(*report.sigma, 4) + "; by the residuals it is " +
                           format_brief(ratio * *report.sigma, 4));
}

void note_large_residuals(FitReport& report) {
    constexpr double improbable = 1e-6;
    if (report.sigma_source == SigmaSource::estimated || !report.chi2_p ||
        !(*report.chi2_p < improbable)) {
        return;
    }
    report.notes.push_back("chi2_p: the residuals are larger than the errors, sigma2 is " +
                           format_brief(report.sigma2.value_or(0), 4));
}

void fill_band(FitReport& report, const SplineFunction& spline, const FitCovariance& covariance) {
    const Interval domain = spline.domain();
    const double factor = covariance.factor_95();
    auto& band = report.covariance_band;
    band.x.resize(band_points);
    band.lower.resize(band_points);
    for (std::size_t i = 0; i < band_points; ++i) {
        const double share = static_cast<double>(i) / (band_points - 1);
        band.x[i] = domain.clamp(domain.lo + domain.length() * share);
    }
    spline.evaluate(band.x, 0, band.lower);
    band.upper = band.lower;
    for (std::size_t i = 0; i < band_points; ++i) {
        const double half = factor * covariance.deviation(band.x[i]);
        band.lower[i] -= half;
        band.upper[i] += half;
    }
}

}  // namespace batten::fitting
