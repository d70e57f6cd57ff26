#include "batten/make/fit_scattered.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "make/fit_surface/choice.hpp"
#include "make/fit_surface/cloud.hpp"
#include "make/fit_surface/filled_report.hpp"
#include "make/fit_surface/shape_of_surface.hpp"

namespace batten {
namespace {

using namespace surface_fitting;

/// As many lines as a grid of so many samples would have.
std::vector<double> typical_lines(Interval range, std::size_t samples) {
    const double side = std::ceil(std::sqrt(static_cast<double>(samples)));
    return even_places(range, std::max<std::size_t>(2, static_cast<std::size_t>(side)));
}

/// The criteria of a delta2 in units of other errors.
void rescale(FitCriteria& criteria, const Cloud& cloud, int parameters, double unit) {
    const double delta2 = criteria.delta2 / (unit * unit);
    criteria = fit_criteria(std::max(criteria.delta2, cloud.least_delta2) / (unit * unit),
                            cloud.count(), parameters, SigmaKnowledge::unknown);
    criteria.delta2 = delta2;
}

/// Where the errors are not known: what is left over is the unit of delta2, of the path too.
void scale_to_leftover(FitSurfaceReport& report, const Cloud& cloud, const SplineSurface& surface) {
    report.sigma = report.sigma2 ? std::sqrt(*report.sigma2) : 0;
    if (!(*report.sigma > 0)) return;
    Psi within{};
    for (std::size_t n = 0; n < cloud.count(); ++n) {
        const double size = std::fabs(cloud.z[n] - surface(cloud.x[n], cloud.y[n])) / *report.sigma;
        for (int w = psi_count; w >= 1 && size <= w; --w) within[static_cast<std::size_t>(w - 1)] += 1;
    }
    for (std::size_t w = 0; w < psi_count; ++w) {
        report.psi[w] = within[w] / static_cast<double>(cloud.count());
    }
    rescale(report, cloud, report.parameters, *report.sigma);
    for (SurfaceStep& step : report.path) rescale(step, cloud, step.parameters, *report.sigma);
}

}  // namespace

SurfaceFit fit_scattered(const ScatteredSamples& samples, const FitSurfaceOptions& options) {
    const Cloud cloud = prepared_cloud(samples, options);
    SurfaceChoice choice = choose_lines(cloud, options);
    const BSplineBasis x(choice.x_knots, options.degree), y(choice.y_knots, options.degree);
    if (cloud.count() < x.size() * y.size()) {
        throw Error("fit.too-few", "samples", std::to_string(cloud.count()),
                    std::to_string(x.size() * y.size()) + " coefficients need at least as many");
    }
    CloudFit fit = fit_cloud(cloud, x, y, options.rule);
    require_finite_solution(fit.solution.coefficients, fit.misfit.delta2);
    FitSurfaceReport report;
    SplineSurface surface(x, y, std::move(fit.solution.coefficients));
    fill_lines(report, surface);
    fill_criteria(report, fit.misfit,
                  {cloud.count(), 0, cloud.sigma_known, cloud.source, cloud.sigma,
                   cloud.least_delta2});
    report.parameters_charged = report.parameters + choice.moved;
    const std::vector<double> across = typical_lines(cloud.domain.x, cloud.count());
    const std::vector<double> along = typical_lines(cloud.domain.y, cloud.count());
    report.separability = separability(surface, across, along);
    report.oscillation = oscillation(surface, across, along);
    report.path = std::move(choice.path);
    if (!cloud.sigma_known) scale_to_leftover(report, cloud, surface);
    report.notes = std::move(choice.notes);
    report.undetermined = std::move(fit.open);
    report.iterations = fit.solution.iterations;
    if (!report.undetermined.empty()) {
        report.notes.push_back("gaps between the samples leave coefficients open: continued smoothly");
    }
    if (fit.faint > 0) {
        report.notes.push_back(std::to_string(fit.faint) +
                               " more coefficients follow from smoothness rather than from samples");
    }
    const auto [least, largest] = std::minmax_element(samples.z.begin(), samples.z.end());
    note_what_lies_beyond(report, surface, {*least, *largest});
    note_what_is_badly_fitted(report);
    const bool is_whole = report.undetermined.empty() && fit.faint == 0;
    const bool is_converged = fit.solution.is_converged && choice.is_converged;
    report.status = !is_whole        ? Status::rank_deficient
                    : !is_converged  ? Status::not_converged
                    : choice.is_met  ? Status::met
                                     : Status::not_met;
    return {std::move(surface), std::move(report)};
}

}  // namespace batten
