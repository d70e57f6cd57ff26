#include "batten/api/fit_outcome.hpp"

#include <utility>

#include "api/fit_table.hpp"

namespace batten {
namespace api {
namespace {

/// What follows from a fit, with deviations.
struct FitFeatures {
    Uncertain integral;
    std::vector<Uncertain> roots, extrema;
};

template <class Visit>
void visit_fields(const FitFeatures& r, Visit&& visit) {
    visit("integral", r.integral, "over the data's range");
    visit("roots", r.roots, "where the spline is 0");
    visit("extrema", r.extrema, "places of the extrema");
}

bool is_continuous(const SplineFunction& spline) {
    const std::size_t degree = static_cast<std::size_t>(spline.degree());
    if (degree == 0) return spline.pieces() == 1;
    const std::span<const double> t = spline.knots();
    for (std::size_t j = 0; j + degree < t.size(); ++j) {
        const bool is_inside = t[j] > spline.domain().lo && t[j] < spline.domain().hi;
        if (is_inside && t[j] == t[j + degree]) return false;
    }
    return true;
}

}  // namespace

Value report_of(const Fit& made) {
    Value report = report_value(made.report);
    if (!made.report.undetermined.empty()) return report;
    const FitCovariance& c = made.covariance;
    const FitFeatures features{c.integral(made.spline.domain()), c.roots(), c.extrema()};
    const Value more = report_value(features);
    for (const auto& entry : *more.map()) report.map()->push_back(entry);
    return report;
}

std::optional<Curve> graph_of(Fit& made) {
    if (!is_continuous(made.spline)) {
        made.report.notes.push_back("the spline has jumps and is no curve");
        return std::nullopt;
    }
    const Curve curve =
        graph(made.spline.degree() == 0 ? elevate_degree(made.spline) : made.spline);
    return made.report.undetermined.empty() ? with_covariance(curve, made.covariance) : curve;
}

MadeSpline spline_of(const Fit& made) {
    if (!made.report.undetermined.empty()) return {made.spline};
    return {made.spline, made.covariance};
}

}  // namespace api

Outcome outcome_of(Fit made) {
    Outcome outcome;
    if (std::optional<Curve> curve = api::graph_of(made)) {
        outcome.draw = [c = *curve] {
            Drawing drawing;
            drawing.add(CurveLayer{c, {}, {}});
            return drawing;
        };
        outcome.output = *std::move(curve);
    }
    outcome.status = made.report.status;
    outcome.report = api::report_of(made);
    outcome.spline = api::spline_of(made);
    return outcome;
}

}  // namespace batten
