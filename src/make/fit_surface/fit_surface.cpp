#include "batten/make/fit_surface.hpp"

#include <cmath>

#include "batten/base/error.hpp"
#include "make/fit_surface/choice.hpp"
#include "make/fit_surface/filled_report.hpp"
#include "make/fit_surface/shape_of_surface.hpp"
#include "make/fit_surface/solve.hpp"

namespace batten {
namespace {

using namespace surface_fitting;

Status surface_status(const FitSurfaceReport& report, const Solution& solution,
                      const SurfaceChoice& choice) {
    if (!report.undetermined.empty()) return Status::rank_deficient;
    if (!solution.is_converged || !choice.is_converged) return Status::not_converged;
    return choice.is_met ? Status::met : Status::not_met;
}

}  // namespace

SurfaceFit fit_surface(const SurfaceSamples& samples, const FitSurfaceOptions& options) {
    const Nodes nodes = prepared_nodes(samples, options);
    SurfaceChoice choice = choose_lines(nodes, options);
    const Axis x = choice.x ? std::move(*choice.x)
                            : Axis(BSplineBasis(choice.x_knots, options.degree), nodes.x,
                                   nodes.x_weight, nodes.used_x());
    const Axis y = choice.y ? std::move(*choice.y)
                            : Axis(BSplineBasis(choice.y_knots, options.degree), nodes.y,
                                   nodes.y_weight, nodes.used_y());
    require_enough_nodes(nodes.count, x.functions() * y.functions());
    const bool is_known = choice.solution.has_value();
    Solution solution =
        is_known ? std::move(*choice.solution) : solve(nodes, x, y, Corrected::where_needed);
    const Misfit measured =
        is_known && !choice.misfit.psi_is_missing
            ? choice.misfit
            : misfit(nodes, x, y, solution.coefficients, std::nullopt);
    if (!std::isfinite(measured.delta2)) require_finite_heights(nodes);
    require_finite_solution(solution.coefficients, measured.delta2);
    FitSurfaceReport report;
    report.undetermined = open_coefficients(nodes, x, y);
    report.iterations = solution.iterations;
    SplineSurface surface(x.basis(), y.basis(), std::move(solution.coefficients));
    fill_lines(report, surface);
    fill_criteria(report, measured, facts_of(nodes));
    report.parameters_charged = report.parameters + choice.moved;
    report.separability = separability(surface, nodes.x, nodes.y);
    report.oscillation = oscillation(surface, nodes.x, nodes.y);
    report.path = std::move(choice.path);
    report.notes = std::move(choice.notes);
    if (!report.undetermined.empty()) {
        report.notes.push_back(note_of_holes);
    }
    if (nodes.missing > 0) note_what_lies_beyond(report, surface, nodes.heights());
    note_what_is_badly_fitted(report);
    report.status = surface_status(report, solution, choice);
    return {std::move(surface), std::move(report)};
}

}  // namespace batten
