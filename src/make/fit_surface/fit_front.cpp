#include "batten/make/fit_front.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "make/fit_surface/exchanged.hpp"
#include "make/fit_surface/filled_report.hpp"
#include "make/fit_surface/front_climb.hpp"
#include "make/fit_surface/front_jump.hpp"
#include "make/fit_surface/front_path.hpp"

namespace batten {
namespace {

using namespace surface_fitting;

constexpr int most_fronts = 3;

using Paths = std::vector<std::vector<double>>;

FrontShape shape_over(const Nodes& nodes, std::size_t fronts) {
    FrontShape shape{{{nodes.x.front(), nodes.x.back()}, {nodes.y.front(), nodes.y.back()}}};
    shape.bundles = static_cast<int>(fronts);
    return shape;
}

std::vector<FrontStart> starts_along(const Paths& paths, double width) {
    std::vector<FrontStart> starts;
    for (const std::vector<double>& path : paths) starts.push_back({path, width});
    return starts;
}

/// Along the paths, from narrow and from wide bundles of four and of five.
FrontTrial first_trial(const Nodes& nodes, const Paths& paths, int most_steps) {
    FrontShape shape = shape_over(nodes, paths.size());
    FrontTrial best;
    for (shape.bundle = jump_lines; shape.bundle <= jump_lines + 1; ++shape.bundle) {
        for (const double width : {4 * cell_of(nodes), 0.16 * shape.domain.x.length()}) {
            FrontTrial next = best_trial(
                nodes, shape, front_start(shape, nodes, starts_along(paths, width)), most_steps);
            if (next.bic < best.bic) best = std::move(next);
        }
    }
    return best;
}

/// Few parameters first: where these leave no more than this, no others are tried.
constexpr double good_sigma2 = 1.15;

/// Along the steepest path, and along further ones as long as bic falls.
FrontTrial along_paths(const Nodes& nodes, int most_steps) {
    Paths paths{steepest_path(nodes)};
    FrontTrial best = first_trial(nodes, paths, most_steps);
    const auto mean = [](const std::vector<double>& path) {
        double sum = 0;
        for (const double x : path) sum += x;
        return sum;
    };
    while (sigma2_of(nodes, best) > good_sigma2 && paths.size() < most_fronts) {
        // Lines need nodes of their own.
        const int lines = shape_over(nodes, paths.size() + 1).x_functions();
        if (nodes.x.size() < 2 * static_cast<std::size_t>(lines)) break;
        paths.push_back(steepest_path(nodes, paths));
        std::sort(paths.begin(), paths.end(), [&](const auto& a, const auto& b) {
            return mean(a) < mean(b);
        });
        FrontTrial more = first_trial(nodes, paths, most_steps);
        if (!(more.bic < best.bic)) break;
        best = std::move(more);
    }
    return best;
}

/// A few steps from there, to see in which direction a front runs.
FrontTrial probe(const Nodes& nodes) {
    constexpr int few_steps = 10;
    FrontShape shape = shape_over(nodes, 1);
    shape.bundle = jump_lines + 1;
    const Paths paths{steepest_path(nodes)};
    return best_trial(nodes, shape,
                      front_start(shape, nodes, starts_along(paths, 4 * cell_of(nodes))),
                      few_steps);
}

constexpr FrontLimits front_limits[] = {{5, 3}, {6, 4}, {6, 6}, {6, 8}};

bool can_hold_a_front(const Nodes& nodes) { return nodes.x.size() >= 8 && nodes.y.size() >= 6; }

FrontReport front_report(const Nodes& nodes, const FrontTrial& trial) {
    const FrontDescent& d = trial.descent;
    FrontReport report;
    report.fronts = d.shape.bundles;
    report.is_jump = trial.jumps > 0;
    report.parameters = d.shape.coefficients();
    report.parameters_charged = report.parameters + trial.moved();
    report.bic = trial.bic;
    report.steps = d.steps;
    report.status = d.is_converged ? Status::met : Status::not_converged;
    report.intervals = {d.shape.lines() + 1, d.shape.y_strips};
    for (int front = 0; d.shape.given.empty() && front < d.shape.bundles; ++front) {
        const double width = bundle_width(d.shape, d.theta, front);
        const bool is_together = width < 1e-9 * d.shape.domain.x.length();
        if (is_together || width >= cell_of(nodes)) continue;
        report.notes.push_back("front " + std::to_string(front + 1) +
                               " is narrower than a cell: its shape there is not in the data");
    }
    return report;
}

void fill_front_lines(FrontReport& report, std::span<const SplineFunction> lines) {
    for (const SplineFunction& line : lines) {
        report.lines.emplace_back(line.coefficients().begin(), line.coefficients().end());
    }
}

}  // namespace

FrontFit fit_front(const SurfaceSamples& samples, const FitFrontOptions& options) {
    FitSurfaceOptions tensor;
    tensor.sigma = options.sigma;
    const Nodes rows = prepared_nodes(samples, tensor);
    const ExchangedSamples other(samples);
    const Nodes columns = prepared_nodes(other.view(), tensor);
    if (!can_hold_a_front(rows) && !can_hold_a_front(columns)) {
        throw Error("fit.too-few", "grid",
                    std::to_string(rows.x.size()) + " x " + std::to_string(rows.y.size()),
                    "a front needs 8 lines in one direction and 6 in the other");
    }
    FrontTrial upright, lying;
    if (can_hold_a_front(rows)) upright = probe(rows);
    if (can_hold_a_front(columns)) lying = probe(columns);
    const bool is_upright = upright.bic <= lying.bic;
    const Nodes& nodes = is_upright ? rows : columns;
    FrontTrial best = along_paths(nodes, options.most_steps);
    if (!std::isfinite(best.bic)) {
        throw Error("number.overflow", "front", "no place", "no bundle of lines fits the domain");
    }
    SurfaceFit product = fit_surface(samples, tensor);
    // Decided before the search: that would find something to gain in any data.
    const bool has_front = best.bic < product.report.bic;
    FrontClimb climb(nodes, std::move(best), options.most_steps);
    for (const FrontLimits& limits : front_limits) {
        if (!has_front) break;
        climb.run(limits);
        if (sigma2_of(nodes, climb.best()) <= good_sigma2) break;
    }
    best = climb.best();
    FrontReport report = front_report(nodes, best);
    report.front = is_upright ? FrontRuns::across_rows : FrontRuns::across_columns;
    CurvedKnotSurface surface =
        front_surface(best.descent.shape, best.descent.theta, best.descent.state.coefficients);
    fill_front_lines(report, surface.x_lines());
    report.path = climb.path();
    if (!is_upright) {
        std::swap(report.intervals[0], report.intervals[1]);
        for (SurfaceStep& step : report.path) std::swap(step.intervals[0], step.intervals[1]);
        surface = exchanged(surface);
    }
    fill_front(report, rows, surface);
    report.tensor_bic = product.report.bic;
    report.has_front = has_front;
    return {std::move(surface), std::move(report), std::move(product)};
}

LinesFit fit_with_lines(const SurfaceSamples& samples, std::span<const SplineFunction> lines,
                        int y_strips, std::optional<double> sigma) {
    FitSurfaceOptions tensor;
    tensor.sigma = sigma;
    const Nodes nodes = prepared_nodes(samples, tensor);
    FrontTrial trial;
    FrontShape& shape = trial.descent.shape;
    shape.domain = {{nodes.x.front(), nodes.x.back()}, {nodes.y.front(), nodes.y.back()}};
    shape.y_strips = y_strips;
    shape.given.assign(lines.begin(), lines.end());
    const bool has_enough = static_cast<int>(nodes.y.size()) >= shape.y_functions() &&
                            nodes.count >= static_cast<std::size_t>(shape.coefficients());
    if (lines.empty() || y_strips < 1 || !has_enough) {
        throw Error("fit.too-few", "grid", std::to_string(nodes.count) + " nodes",
                    std::to_string(shape.coefficients()) + " coefficients need more");
    }
    trial.descent.state = front_state(nodes, shape, {}, Slopes::none);
    trial.descent.is_converged = true;
    if (!std::isfinite(trial.descent.state.delta2)) {
        throw Error("surface.lines", "lines", "crossing or outside",
                    "curved knot lines do not cross and stay inside the domain");
    }
    trial.bic = trial_of(nodes, trial.descent, 0).bic;
    FrontReport report = front_report(nodes, trial);
    fill_front_lines(report, lines);
    report.path = {step_of(nodes, trial)};
    CurvedKnotSurface surface = front_surface(shape, {}, trial.descent.state.coefficients);
    fill_front(report, nodes, surface);
    return {std::move(surface), std::move(report)};
}

}  // namespace batten
