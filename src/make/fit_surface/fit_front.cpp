#include "batten/make/fit_front.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "make/fit_surface/front_model.hpp"

namespace batten {
namespace {

using namespace surface_fitting;

/// A longest step: gaps and logits are logarithms, phi is in domain units.
constexpr double longest_log_step = 0.7;
constexpr double longest_shift = 0.05;  // of the domain

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

double bic_of(const Nodes& nodes, const FrontDescent& d) {
    return d.state.delta2 + (d.shape.coefficients() + d.shape.parameters()) *
                                std::log(static_cast<double>(nodes.count));
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

/// From a narrow and from a wide bundle: the better one.
FrontDescent best_descent(const Nodes& nodes, const FrontShape& shape,
                          const std::vector<double>& path, int most_steps) {
    const double extent = shape.domain.x.length();
    const double cell = extent / static_cast<double>(nodes.x.size() - 1);
    FrontDescent best;
    for (const double width : {4 * cell, 0.16 * extent}) {
        FrontDescent d = descend_front(nodes, shape, front_start(shape, nodes, path, width),
                                       most_steps);
        const bool is_first = best.theta.empty();
        if (is_first || d.state.delta2 < best.state.delta2) best = std::move(d);
    }
    return best;
}

}  // namespace

FrontFit fit_front(const SurfaceSamples& samples, const FitFrontOptions& options) {
    FitSurfaceOptions tensor;
    tensor.sigma = options.sigma;
    const Nodes nodes = prepared_nodes(samples, tensor);
    if (nodes.x.size() < 8 || nodes.y.size() < 4) {
        throw Error("fit.too-few", "grid",
                    std::to_string(nodes.x.size()) + " x " + std::to_string(nodes.y.size()),
                    "a front needs 8 lines in x and 4 in y");
    }
    const std::vector<double> path = steepest_path(nodes);
    FrontShape shape{{{nodes.x.front(), nodes.x.back()}, {nodes.y.front(), nodes.y.back()}}};
    shape.front_intervals = options.front_intervals;
    shape.y_strips = options.y_strips;
    FrontDescent best;
    bool is_jump = false;
    double best_bic = 0;
    const auto offer = [&](FrontDescent d, bool jumps) {
        const double charged = jumps ? std::log(static_cast<double>(nodes.count)) *
                                           (d.shape.bundle - 1)
                                     : 0;
        const double bic = bic_of(nodes, d) - charged;
        if (!best.theta.empty() && !(bic < best_bic)) return;
        best = std::move(d);
        best_bic = bic;
        is_jump = jumps;
    };
    for (shape.bundle = 4; shape.bundle <= std::max(4, options.most_lines); ++shape.bundle) {
        FrontDescent d = best_descent(nodes, shape, path, options.most_steps);
        if (shape.bundle == 4) offer(collapsed(nodes, d), true);
        offer(std::move(d), false);
    }
    if (!std::isfinite(best.state.delta2)) {
        throw Error("number.overflow", "front", "no place", "no bundle of lines fits the domain");
    }
    FrontReport report;
    report.is_jump = is_jump;
    report.parameters = best.shape.coefficients();
    report.line_parameters = best.shape.parameters() - (is_jump ? best.shape.bundle - 1 : 0);
    report.delta2 = best.state.delta2;
    report.sigma2 = report.delta2 / (static_cast<double>(nodes.count) - report.parameters);
    report.bic = best_bic;
    report.tensor_bic = fit_surface(samples, tensor).report.bic;
    report.has_front = report.bic < report.tensor_bic;
    report.steps = best.steps;
    report.status = best.is_converged ? Status::met : Status::not_converged;
    report.intervals = {best.shape.lines() + 1, best.shape.y_strips};
    CurvedKnotSurface surface = front_surface(best.shape, best.theta, best.state.coefficients);
    for (const SplineFunction& line : surface.x_lines()) {
        report.lines.emplace_back(line.coefficients().begin(), line.coefficients().end());
    }
    return {std::move(surface), std::move(report)};
}

}  // namespace batten
