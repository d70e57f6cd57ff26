#include "batten/api/fit_outcome.hpp"

#include <utility>

#include "api/fit_table.hpp"
#include "api/spline_panel.hpp"
#include "api/uncertain_extrema.hpp"
#include "batten/shape/spline_graph.hpp"

namespace batten {
namespace api {
namespace {

/// What follows from a fit, with deviations.
struct FitFeatures {
    Uncertain integral;
    std::vector<UncertainPlace> roots;
    std::vector<UncertainExtremum> extrema;
};

template <class Visit>
void visit_fields(const FitFeatures& r, Visit&& visit) {
    visit("integral", r.integral, "over the data's range");
    visit("roots", r.roots, "where the spline is 0");
    visit("extrema", r.extrema, "minima and maxima, and how sure they are");
}

/// What is known without the data: the spline, its derivative, their bands.
Drawing spline_picture(const MadeSpline& made) {
    const FitCovariance* const covariance = made.covariance ? &*made.covariance : nullptr;
    const NamedBand band{covariance, covariance ? covariance->factor_95() : 0, "95 % band"};
    Drawing drawing;
    drawing.title = "Least-squares spline";
    drawing.width = 1000;
    drawing.columns = 2;
    drawing.panels = {value_panel(made.spline, {}, band, "fit")};
    if (made.spline.degree() > 0) {
        drawing.panels.push_back(derivative_panel(made.spline, 1, {}, band, "fit"));
    }
    return drawing;
}

}  // namespace

Value report_of(const Fit& made) {
    Value report = report_value(made.report);
    if (!made.report.undetermined.empty()) return report;
    const FitCovariance& c = made.covariance;
    const FitFeatures features{c.integral(made.spline.domain()), c.roots(),
                               uncertain_extrema(graph_in_parts(made.spline), &c)};
    const Value more = report_value(features);
    for (const auto& entry : *more.map()) report.map()->push_back(entry);
    return report;
}

Curve curve_of(Fit& made) {
    const Curve curve = graph_in_parts(made.spline);
    if (has_jumps(curve)) {
        made.report.notes.push_back("the spline has jumps: evaluate and draw take it, no operation "
                                    "that follows a curve does");
    }
    return made.report.undetermined.empty() ? with_covariance(curve, made.covariance) : curve;
}

MadeSpline spline_of(const Fit& made) {
    if (!made.report.undetermined.empty()) return {made.spline};
    return {made.spline, made.covariance};
}

}  // namespace api

Outcome outcome_of(Fit made) {
    Outcome outcome;
    const Curve curve = api::curve_of(made);
    outcome.draw = [made = api::spline_of(made)] { return api::spline_picture(made); };
    outcome.output = curve;
    outcome.status = made.report.status;
    outcome.report = api::report_of(made);
    outcome.spline = api::spline_of(made);
    return outcome;
}

}  // namespace batten
