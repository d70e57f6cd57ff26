#include "make/fit_surface/filled_report.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit_surface/residual_totals.hpp"
#include "make/fit_surface/shape_of_surface.hpp"

namespace batten::surface_fitting {

SampleFacts facts_of(const Nodes& nodes) {
    return {nodes.count,  nodes.missing, nodes.sigma_known,
            nodes.source, nodes.sigma,   nodes.least_delta2};
}

void fill_criteria(SurfaceQuality& report, const Misfit& misfit, const SampleFacts& facts) {
    static_cast<FitCriteria&>(report) =
        fit_criteria(std::max(misfit.delta2, facts.least_delta2), facts.count, report.parameters,
                     facts.sigma_known ? SigmaKnowledge::known : SigmaKnowledge::unknown);
    report.delta2 = misfit.delta2;
    report.psi.assign(misfit.psi.begin(), misfit.psi.end());
    report.max_residual = misfit.max_residual;
    report.samples = facts.count;
    report.missing = facts.missing;
    report.sigma = facts.sigma;
    report.sigma_source = facts.source;
    const double degrees = static_cast<double>(facts.count) - report.parameters;
    if (degrees > 0) report.sigma2 = misfit.delta2 / degrees;
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

void note_what_lies_beyond(FitSurfaceReport& report, const SplineSurface& surface,
                           Interval heights) {
    constexpr std::size_t lines = 129;
    const Rectangle domain = surface.domain();
    const Grid z = surface.evaluate(even_places(domain.x, lines), even_places(domain.y, lines));
    const std::span<const double> values = z.view().values();
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    const double room = heights.hi - heights.lo;
    if (*least >= heights.lo - room && *largest <= heights.hi + room) return;
    const auto range = [](double lo, double hi) {
        return format_brief(lo, 4) + " to " + format_brief(hi, 4);
    };
    report.notes.push_back("between the samples the surface goes from " + range(*least, *largest) +
                           ", heights from " + range(heights.lo, heights.hi) +
                           ": fewer strips, or lines that keep clear of the holes, hold it better");
}

namespace {

std::string rounded(double x) { return format_fixed(x, 2); }

/// How far the surface is from one made of one function a direction, to stand behind a note.
std::string apart_from_products(const SurfaceQuality& report) {
    const Separability& s = report.separability;
    return "; separability " + rounded(s.additive) + ", " + rounded(s.product) +
           " (0: made of u(x) and v(y))";
}

/// Notes where more is left than errors would leave.
void note_large_residuals(SurfaceQuality& report) {
    constexpr double improbable = 1e-6;
    if (!report.chi2_p || !(*report.chi2_p < improbable)) return;
    report.notes.push_back("chi2_p: the residuals are larger than the errors, sigma2 is " +
                           rounded(report.sigma2.value_or(0)) + apart_from_products(report));
}

}  // namespace

void note_what_is_badly_fitted(FitSurfaceReport& report) {
    constexpr double swings = 2;
    if (!(report.oscillation > swings)) return note_large_residuals(report);
    report.notes.push_back("oscillation " + rounded(report.oscillation) +
                           ": the surface swings between the samples" +
                           apart_from_products(report) +
                           ": fronts that are not parallel to the axes want curved knot lines");
}

namespace {

/// The ends of a domain and the lines between, which are straight.
std::vector<double> straight_breaks(Interval domain, std::span<const SplineFunction> lines,
                                    bool are_straight) {
    std::vector<double> breaks{domain.lo};
    for (const SplineFunction& line : lines) {
        if (are_straight) breaks.push_back(line.coefficients().front());
    }
    breaks.push_back(domain.hi);
    return breaks;
}

/// delta2, psi and the largest residual of all nodes.
Misfit front_misfit(const Nodes& nodes, const CurvedKnotSurface& surface) {
    NodeTotals totals(nodes);
    std::vector<double> row(nodes.y.size());
    for (std::size_t r = 0; r < nodes.x.size(); ++r) {
        for (std::size_t s = 0; s < row.size(); ++s) row[s] = surface(nodes.x[r], nodes.y[s]);
        totals.add(r, {0, row.size()}, row.data(), row.data());
    }
    Misfit result;
    totals.finish(result);
    return result;
}

}  // namespace

void fill_front(FrontReport& report, const Nodes& nodes, const CurvedKnotSurface& surface) {
    const double charged = report.bic;
    fill_criteria(report, front_misfit(nodes, surface), facts_of(nodes));
    report.bic = charged;
    const bool is_upright = report.front == FrontRuns::across_rows;
    const Rectangle& domain = surface.domain();
    report.breaks_x = straight_breaks(domain.x, surface.x_lines(), !is_upright);
    report.breaks_y = straight_breaks(domain.y, surface.y_lines(), is_upright);
    report.separability = separability(surface, nodes.x, nodes.y);
    report.oscillation = oscillation(surface, nodes.x, nodes.y);
    note_large_residuals(report);
}

void require_enough_nodes(std::size_t nodes, std::size_t coefficients) {
    if (nodes >= coefficients) return;
    throw Error("fit.too-few", "grid", std::to_string(nodes) + " nodes",
                std::to_string(coefficients) + " coefficients need at least as many");
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
