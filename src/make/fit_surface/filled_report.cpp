#include "make/fit_surface/filled_report.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::surface_fitting {

void fill_criteria(FitSurfaceReport& report, const Misfit& misfit, const SampleFacts& facts) {
    static_cast<FitCriteria&>(report) =
        fit_criteria(misfit.delta2, facts.count, report.parameters,
                     facts.sigma_known ? SigmaKnowledge::known : SigmaKnowledge::unknown);
    report.psi.assign(misfit.psi.begin(), misfit.psi.end());
    report.max_residual = misfit.max_residual;
    report.samples = facts.count;
    report.missing = facts.missing;
    report.sigma = facts.sigma;
    report.sigma_source = facts.source;
    const double degrees = static_cast<double>(facts.count) - report.parameters;
    if (facts.sigma_known && degrees > 0) report.chi2_p = chi2_survival(misfit.delta2, degrees);
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

void require_finite_solution(const std::vector<double>& coefficients, double delta2) {
    const bool is_finite = std::isfinite(delta2) &&
                           std::all_of(coefficients.begin(), coefficients.end(),
                                       [](double c) { return std::isfinite(c); });
    if (is_finite) return;
    throw Error("number.overflow", "surface", format_number(delta2),
                "a coefficient or delta2 is beyond the range of a double");
}

}  // namespace batten::surface_fitting
