#include "batten/make/fit_front.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit_surface/exchanged.hpp"
#include "make/fit_surface/front_model.hpp"

namespace batten {
namespace {

using namespace surface_fitting;

/// A longest step: gaps and logits are logarithms, phi is in domain units.
constexpr double longest_log_step = 0.7;
constexpr double longest_shift = 0.05;  // of the domain
constexpr int jump_lines = 4;           // that run together make a jump: the order of a cubic

struct FrontDescent {
    FrontShape shape;
    std::vector<double> theta;
    FrontState state;
    int steps = 0;
    bool is_converged = false;
};

/// Step of Levenberg and Marquardt, cut to what the local model can be trusted for.
std::vector<double> damped_step(const FrontShape& shape, const FrontState& state, double damping) {
    const int n = shape.parameters();
    Eigen::MatrixXd normal = Eigen::Map<const Eigen::MatrixXd>(state.normal.data(), n, n);
    const double floor = 1e-12 * normal.diagonal().maxCoeff();
    for (int k = 0; k < n; ++k) {
        normal(k, k) += damping * std::max(normal(k, k), floor) + floor;
    }
    const Eigen::VectorXd step =
        -normal.ldlt().solve(Eigen::Map<const Eigen::VectorXd>(state.gradient.data(), n));
    double cut = 1;
    for (int k = 0; k < n; ++k) {
        const double most = k < shape.front_values() ? longest_shift * shape.domain.x.length()
                                                     : longest_log_step;
        if (std::fabs(step[k]) * cut > most) cut = most / std::fabs(step[k]);
    }
    std::vector<double> result(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) result[static_cast<std::size_t>(k)] = cut * step[k];
    return result;
}

FrontDescent descend_front(const Nodes& nodes, const FrontShape& shape, std::vector<double> theta,
                           int most_steps) {
    FrontDescent d{shape, std::move(theta), {}, 0, false};
    d.state = front_state(nodes, shape, d.theta, Slopes::wanted);
    double damping = 1e-2;
    while (std::isfinite(d.state.delta2) && d.steps < most_steps && damping < 1e8) {
        const std::vector<double> step = damped_step(shape, d.state, damping);
        std::vector<double> next = d.theta;
        for (std::size_t k = 0; k < next.size(); ++k) next[k] += step[k];
        ++d.steps;
        const double delta2 = front_state(nodes, shape, next, Slopes::none).delta2;
        if (!(delta2 < d.state.delta2)) {
            damping *= 4;
            continue;
        }
        const double gain = d.state.delta2 - delta2;
        d.theta = std::move(next);
        d.state = front_state(nodes, shape, d.theta, Slopes::wanted);
        damping = std::max(1e-9, damping * 0.3);
        if (gain <= 1e-7 * delta2) {
            d.is_converged = true;
            break;
        }
    }
    d.is_converged = d.is_converged || damping >= 1e8;
    return d;
}

/// A descent that may win.
struct FrontTrial {
    FrontDescent descent;
    bool is_jump = false;
    double bic = std::numeric_limits<double>::infinity();  ///< moved parameters charged

    int moved() const { return descent.shape.parameters() - (is_jump ? descent.shape.bundle - 1 : 0); }
};

FrontTrial trial_of(const Nodes& nodes, FrontDescent d, bool is_jump) {
    FrontTrial trial{std::move(d), is_jump};
    trial.bic = trial.descent.state.delta2 +
                (trial.descent.shape.coefficients() + trial.moved()) *
                    std::log(static_cast<double>(nodes.count));
    return trial;
}

/// The bundle of four run together: a jump. Its gaps are no parameters any more.
FrontDescent collapsed(const Nodes& nodes, FrontDescent d) {
    const std::size_t first = static_cast<std::size_t>(d.shape.front_values());
    for (std::size_t g = 0; g + 1 < static_cast<std::size_t>(d.shape.bundle); ++g) {
        d.theta[first + g] = std::log(1e-14 * d.shape.domain.x.length());
    }
    d.state = front_state(nodes, d.shape, d.theta, Slopes::none);
    return d;
}

/// The descent from there, as it is or run together: the better one.
FrontTrial best_trial(const Nodes& nodes, const FrontShape& shape, std::vector<double> start,
                      int most_steps) {
    FrontDescent d = descend_front(nodes, shape, std::move(start), most_steps);
    FrontTrial jump;
    if (shape.bundle == jump_lines) jump = trial_of(nodes, collapsed(nodes, d), true);
    FrontTrial open = trial_of(nodes, std::move(d), false);
    return jump.bic < open.bic ? jump : open;
}

double cell_of(const Nodes& nodes) {
    return (nodes.x.back() - nodes.x.front()) / static_cast<double>(nodes.x.size() - 1);
}

/// Along the steepest path, from a narrow and from a wide bundle of four and of five.
FrontTrial first_trial(const Nodes& nodes, int most_steps) {
    FrontShape shape{{{nodes.x.front(), nodes.x.back()}, {nodes.y.front(), nodes.y.back()}}};
    const std::vector<double> path = steepest_path(nodes);
    FrontTrial best;
    for (shape.bundle = jump_lines; shape.bundle <= jump_lines + 1; ++shape.bundle) {
        for (const double width : {4 * cell_of(nodes), 0.16 * shape.domain.x.length()}) {
            FrontTrial next = best_trial(nodes, shape, front_start(shape, nodes, path, width),
                                         most_steps);
            if (next.bic < best.bic) best = std::move(next);
        }
    }
    return best;
}

/// A few steps from there, to see in which direction a front runs.
FrontTrial probe(const Nodes& nodes) {
    constexpr int few_steps = 10;
    FrontShape shape{{{nodes.x.front(), nodes.x.back()}, {nodes.y.front(), nodes.y.back()}}};
    shape.bundle = jump_lines + 1;
    return best_trial(nodes, shape,
                      front_start(shape, nodes, steepest_path(nodes), 4 * cell_of(nodes)),
                      few_steps);
}

/// The parameters of another shape for the same front, nowhere narrower than half a cell.
std::vector<double> carried_over(const Nodes& nodes, const FrontDescent& from,
                                 const FrontShape& to) {
    const BSplineBasis basis = BSplineBasis::over(
        even_places(from.shape.domain.y, static_cast<std::size_t>(from.shape.front_intervals) + 1),
        3);
    const SplineFunction phi({basis.knots().begin(), basis.knots().end()},
                             {from.theta.begin(), from.theta.begin() + from.shape.front_values()},
                             3);
    std::vector<double> path;
    for (const double y : nodes.y) path.push_back(phi(y));
    double width = 0;
    for (int g = 0; g + 1 < from.shape.bundle; ++g) {
        width += std::exp(from.theta[static_cast<std::size_t>(from.shape.front_values() + g)]);
    }
    std::vector<double> theta =
        front_start(to, nodes, path, std::max(width, 0.5 * cell_of(nodes)));
    std::copy(from.theta.end() - 2, from.theta.end(), theta.end() - 2);
    return theta;
}

/// The most lines along a front, and intervals of it and across.
struct FrontLimits {
    int lines, intervals;
};

/// Few parameters first: where these leave no more than `good_sigma2`, no others are tried.
constexpr FrontLimits front_limits[] = {{5, 3}, {6, 4}, {6, 6}, {6, 8}};
constexpr double good_sigma2 = 1.15;

/// One line, interval or strip more or less, as long as bic falls.
FrontTrial climbed_trial(const Nodes& nodes, FrontTrial best, const FrontLimits& limits,
                         int most_steps) {
    struct Move {
        int FrontShape::*number;
        int change, least, most;
    };
    const int lines = std::max(jump_lines, limits.lines);
    const int across = std::min(limits.intervals, static_cast<int>(nodes.y.size()) - 3);
    const Move moves[] = {{&FrontShape::y_strips, 1, 1, across},
                          {&FrontShape::y_strips, -1, 1, across},
                          {&FrontShape::front_intervals, 1, 1, across},
                          {&FrontShape::front_intervals, -1, 1, across},
                          {&FrontShape::bundle, 1, 2, lines},
                          {&FrontShape::bundle, -1, 2, lines}};
    for (bool is_rising = true; is_rising;) {
        is_rising = false;
        for (const Move& move : moves) {
            FrontShape shape = best.descent.shape;
            shape.*move.number += move.change;
            if (shape.*move.number < move.least || shape.*move.number > move.most) continue;
            FrontTrial next = best_trial(nodes, shape, carried_over(nodes, best.descent, shape),
                                         most_steps);
            if (!(next.bic < best.bic)) continue;
            best = std::move(next);
            is_rising = true;
        }
    }
    return best;
}

bool can_hold_a_front(const Nodes& nodes) { return nodes.x.size() >= 8 && nodes.y.size() >= 6; }

FrontReport front_report(const Nodes& nodes, const FrontTrial& trial) {
    const FrontDescent& d = trial.descent;
    FrontReport report;
    report.is_jump = trial.is_jump;
    report.parameters = d.shape.coefficients();
    report.line_parameters = trial.moved();
    report.delta2 = d.state.delta2;
    report.sigma2 = report.delta2 / (static_cast<double>(nodes.count) - report.parameters);
    report.bic = trial.bic;
    report.steps = d.steps;
    report.status = d.is_converged ? Status::met : Status::not_converged;
    report.intervals = {d.shape.lines() + 1, d.shape.y_strips};
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
    FrontTrial best = first_trial(nodes, options.most_steps);
    if (!std::isfinite(best.bic)) {
        throw Error("number.overflow", "front", "no place", "no bundle of lines fits the domain");
    }
    SurfaceFit product = fit_surface(samples, tensor);
    // Decided before the search: that would find something to gain in any data.
    const bool has_front = best.bic < product.report.bic;
    for (const FrontLimits& limits : front_limits) {
        if (!has_front) break;
        best = climbed_trial(nodes, std::move(best), limits, options.most_steps);
        if (front_report(nodes, best).sigma2 <= good_sigma2) break;
    }
    FrontReport report = front_report(nodes, best);
    report.front = is_upright ? FrontRuns::across_rows : FrontRuns::across_columns;
    CurvedKnotSurface surface =
        front_surface(best.descent.shape, best.descent.theta, best.descent.state.coefficients);
    fill_front_lines(report, surface.x_lines());
    if (!is_upright) {
        std::swap(report.intervals[0], report.intervals[1]);
        surface = exchanged(surface);
    }
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
    trial.bic = trial_of(nodes, trial.descent, false).bic;
    FrontReport report = front_report(nodes, trial);
    fill_front_lines(report, lines);
    return {front_surface(shape, {}, trial.descent.state.coefficients), std::move(report)};
}

std::vector<SplineFunction> lines_through(const Points& rows) {
    const std::size_t n = rows.size();
    if (n == 0 || rows.dim() < 2) {
        throw Error("surface.lines", "lines", std::to_string(n) + " rows",
                    "rows y, X_1, X_2, … are needed");
    }
    std::vector<double> y;
    for (std::size_t i = 0; i < n; ++i) {
        y.push_back(rows(i, 0));
        if (i == 0 || y[i - 1] < y[i]) continue;
        throw Error("surface.lines", "row " + std::to_string(i), format_number(y[i]),
                    "the rows of knot lines rise in y");
    }
    if (n == 1) throw Error("surface.lines", "lines", "one row", "at least two rows are needed");
    // Not-a-knot: the second and the last but one place are no knots.
    const int degree = static_cast<int>(std::min<std::size_t>(3, n - 1));
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, y.front());
    for (std::size_t i = 2; degree == 3 && i + 2 < n; ++i) knots.push_back(y[i]);
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, y.back());
    const BSplineBasis basis(knots, degree);
    const int size = static_cast<int>(n);
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(size, size);
    for (int i = 0; i < size; ++i) {
        double local[4];
        basis.nonzero(y[static_cast<std::size_t>(i)], 0, local);
        const int first = static_cast<int>(basis.span_of(y[static_cast<std::size_t>(i)])) - degree;
        for (int j = 0; j <= degree; ++j) values(i, first + j) = local[j];
    }
    const Eigen::PartialPivLU<Eigen::MatrixXd> solver(values);
    std::vector<SplineFunction> lines;
    for (int k = 1; k < rows.dim(); ++k) {
        Eigen::VectorXd places(size);
        for (int i = 0; i < size; ++i) places[i] = rows(static_cast<std::size_t>(i), k);
        const Eigen::VectorXd c = solver.solve(places);
        lines.emplace_back(knots, std::vector<double>(c.data(), c.data() + size), degree);
    }
    return lines;
}

}  // namespace batten
