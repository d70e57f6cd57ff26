#include "batten/make/fit_surface.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit_surface/choice.hpp"
#include "make/fit_surface/shape_of_surface.hpp"
#include "make/fit_surface/solve.hpp"

namespace batten {
namespace {

using namespace surface_fitting;

void fill_surface_criteria(FitSurfaceReport& report, const Nodes& nodes, const Misfit& misfit) {
    const FitCriteria c =
        fit_criteria(misfit.delta2, nodes.count, report.parameters,
                     nodes.sigma_known ? SigmaKnowledge::known : SigmaKnowledge::unknown);
    report.delta2 = misfit.delta2;
    report.sigma2 = c.sigma2;
    report.aic = c.aic;
    report.bic = c.bic;
    report.aicc = c.aicc;
    report.gcv = c.gcv;
    report.psi.assign(misfit.psi.begin(), misfit.psi.end());
    report.max_residual = misfit.max_residual;
    report.samples = nodes.count;
    report.missing = nodes.missing;
    report.sigma = nodes.sigma;
    report.sigma_source = nodes.source;
    const double degrees = static_cast<double>(nodes.count) - report.parameters;
    if (nodes.sigma_known && degrees > 0) report.chi2_p = chi2_survival(misfit.delta2, degrees);
}

void fill_lines(FitSurfaceReport& report, const SplineSurface& surface) {
    const auto copy = [](std::span<const double> from) {
        return std::vector<double>(from.begin(), from.end());
    };
    report.knots_x = copy(surface.x_basis().knots());
    report.knots_y = copy(surface.y_basis().knots());
    report.breaks_x = copy(surface.x_basis().breaks());
    report.breaks_y = copy(surface.y_basis().breaks());
    report.intervals = {static_cast<int>(report.breaks_x.size()) - 1,
                        static_cast<int>(report.breaks_y.size()) - 1};
    report.parameters = static_cast<int>(surface.coefficients().size());
}

Status surface_status(const FitSurfaceReport& report, const Solution& solution, bool is_met) {
    if (!report.undetermined.empty()) return Status::rank_deficient;
    if (!solution.is_converged) return Status::not_converged;
    return is_met ? Status::met : Status::not_met;
}

void require_finite_solution(const std::vector<double>& coefficients, double delta2) {
    const bool is_finite = std::isfinite(delta2) &&
                           std::all_of(coefficients.begin(), coefficients.end(),
                                       [](double c) { return std::isfinite(c); });
    if (is_finite) return;
    throw Error("number.overflow", "surface", format_number(delta2),
                "a coefficient or delta2 is beyond the range of a double");
}

}  // namespace

SurfaceFit fit_surface(const SurfaceSamples& samples, const FitSurfaceOptions& options) {
    const Nodes nodes = prepared_nodes(samples, options);
    SurfaceChoice choice = choose_lines(nodes, options);
    const Axis x(BSplineBasis(choice.x_knots, options.degree), nodes.x, nodes.x_weight,
                 nodes.used_x());
    const Axis y(BSplineBasis(choice.y_knots, options.degree), nodes.y, nodes.y_weight,
                 nodes.used_y());
    const std::size_t parameters = x.functions() * y.functions();
    if (nodes.count < parameters) {
        throw Error("fit.too-few", "grid", std::to_string(nodes.count) + " nodes",
                    std::to_string(parameters) + " coefficients need at least as many");
    }
    Solution solution = solve(nodes, x, y, Corrected::where_needed);
    const Misfit measured = misfit(nodes, x, y, solution.coefficients, std::nullopt);
    require_finite_solution(solution.coefficients, measured.delta2);
    FitSurfaceReport report;
    report.undetermined = open_coefficients(nodes, x, y);
    report.iterations = solution.iterations;
    SplineSurface surface(x.basis(), y.basis(), std::move(solution.coefficients));
    fill_lines(report, surface);
    fill_surface_criteria(report, nodes, measured);
    report.parameters_charged = report.parameters + choice.moved;
    report.separability = separability(surface, nodes.x, nodes.y);
    report.oscillation = oscillation(surface, nodes.x, nodes.y);
    report.path = std::move(choice.path);
    report.notes = std::move(choice.notes);
    if (!report.undetermined.empty()) {
        report.notes.push_back("holes in the data leave coefficients open: continued smoothly");
    }
    report.status = surface_status(report, solution, choice.is_met);
    return {std::move(surface), std::move(report)};
}

}  // namespace batten
