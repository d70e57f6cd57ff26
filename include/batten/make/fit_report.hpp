#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/make/fit_statistics.hpp"

namespace batten {

/// Where the errors of the data come from.
enum class SigmaSource { column, number, model, estimated };

constexpr std::array<Named<SigmaSource>, 4> names_of(SigmaSource) {
    return {{{"column", SigmaSource::column},
             {"number", SigmaSource::number},
             {"model", SigmaSource::model},
             {"estimated", SigmaSource::estimated}}};
}

/// One step on the way to the final number of intervals.
struct FitStep : FitCriteria {
    int intervals = 0;
    int parameters_charged = 0;  ///< by which the rule decides; the criteria here are the paper's
    std::vector<double> psi;     ///< listed up to 20,000 samples, or where the rule asks for it
};

template <class Visit>
void visit_fields(const FitStep& r, Visit&& visit) {
    visit("intervals", r.intervals, "inner knots, counted with their multiplicity, and 1");
    visit("parameters_charged", r.parameters_charged, "p and the knots that were moved");
    visit_fields(static_cast<const FitCriteria&>(r), visit);
    visit("psi", r.psi, "shares of the residuals within 1, 2, ... 10 sigma");
}

/// A band that holds the true value with 95 % probability at each abscissa by itself.
struct FitBand {
    std::vector<double> x, lower, upper;
};

template <class Visit>
void visit_fields(const FitBand& r, Visit&& visit) {
    visit("x", r.x, "abscissae");
    visit("lower", r.lower, "lower edge");
    visit("upper", r.upper, "upper edge");
}

struct FitReport : FitCriteria {
    int intervals = 0;
    int parameters = 0;
    int parameters_charged = 0;
    std::optional<double> chi2_p;
    std::optional<double> runs_p;
    std::vector<double> psi;
    std::vector<double> breaks;
    std::vector<double> knots;
    std::vector<double> coefficients;
    FitBand covariance_band;
    std::vector<FitStep> path;
    std::size_t samples = 0;
    SigmaSource sigma_source = SigmaSource::estimated;
    std::optional<double> sigma;
    int rank = 0;
    std::vector<int> undetermined;
    std::vector<std::size_t> rejected;
    std::vector<double> suggestions;
    std::optional<double> max_residual;
    Status status = Status::met;
    std::vector<std::string> notes;
};

template <class Visit>
void visit_fields(const FitReport& r, Visit&& visit) {
    visit("intervals", r.intervals, "n: inner knots, counted with their multiplicity, and 1");
    visit("parameters", r.parameters, "p: number of coefficients, the paper's count");
    visit("parameters_charged", r.parameters_charged, "p and the knots that were moved");
    visit_fields(static_cast<const FitCriteria&>(r), visit);
    visit("chi2_p", r.chi2_p, "probability of a larger delta2 if the errors are as stated");
    visit("runs_p", r.runs_p, "probability of fewer changes of sign in the residuals by chance");
    visit("psi", r.psi, "shares of the residuals within 1, 2, ... 10 sigma");
    visit("breaks", r.breaks, "distinct knots, both ends included");
    visit("knots", r.knots, "the full knot vector");
    visit("coefficients", r.coefficients, "B-spline coefficients, coordinate after coordinate");
    visit("covariance_band", r.covariance_band, "95 % band of the value, pointwise");
    visit("path", r.path, "every number of intervals tried");
    visit("samples", r.samples, "N: samples with weight");
    visit("sigma_source", r.sigma_source, "where the errors of the data come from");
    visit("sigma", r.sigma, "the error used, where it is one number");
    visit("rank", r.rank, "number of coefficients the data determine");
    visit("undetermined", r.undetermined, "coefficients the data do not determine");
    visit("rejected", r.rejected, "samples without weight because of their residuals, from 0");
    visit("suggestions", r.suggestions, "abscissae where a measurement narrows the band most");
    visit("max_residual", r.max_residual, "largest |residual|, data units");
    visit("notes", r.notes, "what else there is to say");
}

}  // namespace batten
