#include "batten/make/fit_front.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "batten/base/error.hpp"
#include "make/fit_surface/exchanged.hpp"
#include "make/fit_surface/filled_report.hpp"
#include "make/fit_surface/front_jump.hpp"
#include "make/fit_surface/front_model.hpp"
#include "make/fit_surface/front_path.hpp"

namespace batten {
namespace {

using namespace surface_fitting;

/// A longest step: gaps and logits are logarithms, phi is in domain units.
constexpr double longest_log_step = 0.7;
constexpr double still_front = 1e-6;  // of delta2: a descent ends where a step gains less
constexpr double longest_shift = 0.05;  // of the domain
constexpr int most_fronts = 3;
/// A jump leaves no more than this share of what the open bundle leaves: phi lies well enough.
constexpr double good_jump = 1.02;
constexpr double hopeful_jump = 2;  // before the other parameters have followed

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
        const double most = shape.is_place(k) ? longest_shift * shape.domain.x.length()
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
        FrontState state = front_state(nodes, shape, next, Slopes::wanted);
        if (!(state.delta2 < d.state.delta2)) {
            damping *= 4;
            continue;
        }
        const double gain = d.state.delta2 - state.delta2;
        d.theta = std::move(next);
        d.state = std::move(state);
        damping = std::max(1e-9, damping * 0.3);
        if (gain <= still_front * d.state.delta2) {
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
    int jumps = 0;                                         ///< bundles that were run together
    double bic = std::numeric_limits<double>::infinity();  ///< moved parameters charged

    /// The gaps of a jump are no parameters.
    int moved() const {
        return descent.shape.parameters() - jumps * (descent.shape.bundle - 1);
    }
};

FrontTrial trial_of(const Nodes& nodes, FrontDescent d, int jumps) {
    FrontTrial trial{std::move(d), jumps};
    trial.bic = trial.descent.state.delta2 +
                (trial.descent.shape.coefficients() + trial.moved()) *
                    std::log(static_cast<double>(nodes.count));
    return trial;
}

double cell_of(const Nodes& nodes) {
    return (nodes.x.back() - nodes.x.front()) / static_cast<double>(nodes.x.size() - 1);
}

/// Where the bundles of a descent are.
std::vector<FrontStart> starts_of(const Nodes& nodes, const FrontDescent& from) {
    std::vector<FrontStart> starts;
    for (int front = 0; front < from.shape.bundles; ++front) {
        const SplineFunction phi = front_curve(from.shape, from.theta, front);
        FrontStart start{{}, bundle_width(from.shape, from.theta, front)};
        for (const double y : nodes.y) start.path.push_back(phi(y));
        starts.push_back(std::move(start));
    }
    return starts;
}

/// The logits of the lines beside, where both shapes have such.
void copy_sides(const FrontDescent& from, const FrontShape& to, std::vector<double>& theta) {
    if (from.shape.sides() != to.sides()) return;
    std::copy(from.theta.begin() + static_cast<std::ptrdiff_t>(from.shape.sides_at()),
              from.theta.end(), theta.begin() + static_cast<std::ptrdiff_t>(to.sides_at()));
}

/// The parameters of another shape for the same fronts, nowhere narrower than half a cell, and not
/// so narrow that a spline would be without nodes.
std::vector<double> carried_over(const Nodes& nodes, const FrontDescent& from,
                                 const FrontShape& to) {
    std::vector<FrontStart> starts = starts_of(nodes, from);
    const double cells = to.bundle > jump_lines ? 0.3 * (to.bundle - 1) : 0.5;
    for (FrontStart& start : starts) start.width = std::max(start.width, cells * cell_of(nodes));
    std::vector<double> theta = front_start(to, nodes, starts);
    copy_sides(from, to, theta);
    return theta;
}

/// The parameters of the same lines with so many intervals of phi.
std::vector<double> with_intervals(const Nodes& nodes, const FrontDescent& from, int intervals) {
    if (intervals == from.shape.front_intervals) return from.theta;
    FrontShape to = from.shape;
    to.front_intervals = intervals;
    std::vector<double> theta = front_start(to, nodes, starts_of(nodes, from));
    copy_sides(from, to, theta);
    for (int front = 0; front < to.bundles; ++front) {
        std::copy_n(from.theta.begin() + static_cast<std::ptrdiff_t>(from.shape.gaps_at(front)),
                    to.bundle - 1, theta.begin() + static_cast<std::ptrdiff_t>(to.gaps_at(front)));
    }
    return theta;
}

/// The most intervals of phi that are tried for a jump: it has to pass between nodes in every row.
constexpr int most_jump_intervals = 8;

/// The same with one more bundle run together, and as many intervals as that needs.
FrontTrial with_jump(const Nodes& nodes, const FrontTrial& from, int front, int most_steps) {
    FrontTrial best;
    FrontShape shape = from.descent.shape;
    const double open = from.descent.state.delta2;
    const int most = std::min(std::max(most_jump_intervals, shape.front_intervals),
                              static_cast<int>(nodes.y.size()) - 3);
    double before = std::numeric_limits<double>::infinity();
    for (; shape.front_intervals <= most; ++shape.front_intervals) {
        std::vector<double> theta = jump_at(
            nodes, shape, with_intervals(nodes, from.descent, shape.front_intervals), front);
        const double delta2 = front_state(nodes, shape, theta, Slopes::none).delta2;
        if (delta2 <= hopeful_jump * open) {
            FrontTrial next = trial_of(
                nodes, descend_front(nodes, shape, std::move(theta), most_steps), from.jumps + 1);
            const bool is_good = next.descent.state.delta2 <= good_jump * open;
            if (next.bic < best.bic) best = std::move(next);
            if (is_good) break;
        }
        if (delta2 > 0.5 * before) break;  // more intervals are of little help
        before = delta2;
    }
    return best;
}

/// The descent from there, its bundles as they are or run together: the best one.
FrontTrial best_trial(const Nodes& nodes, const FrontShape& shape, std::vector<double> start,
                      int most_steps) {
    FrontTrial best = trial_of(
        nodes, descend_front(nodes, shape, std::move(start), most_steps), 0);
    if (shape.bundle != jump_lines || !std::isfinite(best.bic)) return best;
    for (int front = 0; front < shape.bundles; ++front) {
        FrontTrial jump = with_jump(nodes, best, front, most_steps);
        if (jump.bic < best.bic) best = std::move(jump);
    }
    return best;
}

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

/// What is left a node, by the paper's count.
double sigma2_of(const Nodes& nodes, const FrontTrial& trial) {
    return trial.descent.state.delta2 /
           (static_cast<double>(nodes.count) - trial.descent.shape.coefficients());
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

/// The most lines along a front, and intervals of it and across.
struct FrontLimits {
    int lines, intervals;
};

constexpr FrontLimits front_limits[] = {{5, 3}, {6, 4}, {6, 6}, {6, 8}};

/// A trial as a step of the path: bic with the moved parameters charged.
SurfaceStep step_of(const Nodes& nodes, const FrontTrial& trial) {
    const FrontShape& shape = trial.descent.shape;
    SurfaceStep step{fit_criteria(trial.descent.state.delta2, nodes.count, shape.coefficients(),
                                  SigmaKnowledge::known),
                     {shape.lines() + 1, shape.y_strips},
                     shape.coefficients(),
                     {}};
    step.bic = trial.bic;
    return step;
}

/// One line, interval or strip more or less, as long as bic falls; every shape is tried once.
class Climb {
public:
    Climb(const Nodes& nodes, FrontTrial start, int most_steps)
        : nodes_(nodes), best_(std::move(start)), most_steps_(most_steps) {
        tried_.insert(numbers_of(best_.descent.shape));
        path_.push_back(step_of(nodes_, best_));
    }

    const FrontTrial& best() const { return best_; }
    const std::vector<SurfaceStep>& path() const { return path_; }

    void run(const FrontLimits& limits) {
        const int lines = std::max(jump_lines, limits.lines);
        const int across = std::min(limits.intervals, static_cast<int>(nodes_.y.size()) - 3);
        const Move moves[] = {{&FrontShape::y_strips, 1, 1, across},
                              {&FrontShape::y_strips, -1, 1, across},
                              {&FrontShape::front_intervals, 1, 1, across},
                              {&FrontShape::front_intervals, -1, 1, across},
                              {&FrontShape::bundle, 1, 2, lines},
                              {&FrontShape::bundle, -1, 2, lines},
                              {&FrontShape::beside, -1, 0, 1},
                              {&FrontShape::beside, 1, 0, 1}};
        for (bool is_rising = true; is_rising;) {
            is_rising = false;
            for (const Move& move : moves) is_rising = takes(move) || is_rising;
        }
    }

private:
    struct Move {
        int FrontShape::*number;
        int change, least, most;
    };
    using Numbers = std::array<int, 4>;

    static Numbers numbers_of(const FrontShape& shape) {
        return {shape.bundle, shape.beside, shape.front_intervals, shape.y_strips};
    }

    /// Whether bic falls by that.
    bool takes(const Move& move) {
        FrontShape shape = best_.descent.shape;
        shape.*move.number += move.change;
        if (shape.*move.number < move.least || shape.*move.number > move.most) return false;
        if (!tried_.insert(numbers_of(shape)).second) return false;
        FrontTrial next = best_trial(nodes_, shape, carried_over(nodes_, best_.descent, shape),
                                     most_steps_);
        if (std::isfinite(next.bic)) path_.push_back(step_of(nodes_, next));
        if (!(next.bic < best_.bic)) return false;
        best_ = std::move(next);
        return true;
    }

    const Nodes& nodes_;
    FrontTrial best_;
    std::vector<SurfaceStep> path_;
    int most_steps_;
    std::set<Numbers> tried_;
};

bool can_hold_a_front(const Nodes& nodes) { return nodes.x.size() >= 8 && nodes.y.size() >= 6; }

FrontReport front_report(const Nodes& nodes, const FrontTrial& trial) {
    const FrontDescent& d = trial.descent;
    FrontReport report;
    report.fronts = d.shape.bundles;
    report.is_jump = trial.jumps > 0;
    report.parameters = d.shape.coefficients();
    report.line_parameters = trial.moved();
    report.delta2 = d.state.delta2;
    report.sigma2 = sigma2_of(nodes, trial);
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
    Climb climb(nodes, std::move(best), options.most_steps);
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
