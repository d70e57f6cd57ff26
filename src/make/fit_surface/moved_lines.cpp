#include "make/fit_surface/moved_lines.hpp"

#include <algorithm>
#include <cmath>

namespace batten::surface_fitting {
namespace {

constexpr int most_steps = 200;
constexpr double still = 1e-6;       // of delta2: a step that gains less is the last but one
constexpr double widest_step = 0.3;  // of the narrower strip beside a line
constexpr double first_damping = 1e-2, least_damping = 1e-8, most_damping = 1e6;

/// Adds the step of a model, each line kept away from its neighbours in `before`.
void add_step(const KnotModel& model, const KnotPair& before, double damping, KnotPair& to) {
    num::SymmetricMatrix matrix = model.normal;
    double largest = 0;
    for (std::size_t i = 0; i < matrix.size; ++i) largest = std::max(largest, matrix(i, i));
    if (!(largest > 0)) return;
    for (std::size_t i = 0; i < matrix.size; ++i) {
        matrix(i, i) += damping * std::max(matrix(i, i), 1e-6 * largest);
    }
    std::vector<double> right = model.gradient;
    for (double& g : right) g = -g;
    const std::vector<double> step =
        num::solve_positive(matrix, right).value_or(std::vector<double>(matrix.size, 0.0));
    for (std::size_t i = 0; i < step.size(); ++i) {
        const auto [side, l] = model.knots[i];
        const std::vector<double>& t = before[side];
        const double room = widest_step * std::min(t[l] - t[l - 1], t[l + 1] - t[l]);
        to[side][l] += std::clamp(step[i], -room, room);
    }
}

}  // namespace

std::vector<std::size_t> simple_knots(const std::vector<double>& t, int degree) {
    std::vector<std::size_t> simple;
    const std::size_t order = static_cast<std::size_t>(degree) + 1;
    for (std::size_t l = order; l + order < t.size(); ++l) {
        if (t[l - 1] < t[l] && t[l] < t[l + 1]) simple.push_back(l);
    }
    return simple;
}

MovedLines descend(MovableLines& lines, int degree) {
    MovedLines result;
    for (const std::vector<double>& t : lines.knots()) {
        result.moved += static_cast<int>(simple_knots(t, degree).size());
    }
    if (degree == 0 || result.moved == 0 || !std::isfinite(lines.delta2())) {
        return {lines.knots(), 0, 0, true};
    }
    double damping = first_damping;
    int small_gains = 0;
    while (result.steps < most_steps && small_gains < 2 && damping <= most_damping) {
        const std::vector<KnotModel> models = lines.models();
        bool is_better = false;
        for (; damping <= most_damping && !is_better; damping *= is_better ? 1 : 8) {
            const double before = lines.delta2();
            KnotPair next = lines.knots();
            for (const KnotModel& model : models) add_step(model, lines.knots(), damping, next);
            is_better = lines.improves_by(std::move(next));
            if (!is_better) continue;
            result.last_gain = before > 0 ? (before - lines.delta2()) / before : 0;
            small_gains = before - lines.delta2() <= still * before ? small_gains + 1 : 0;
        }
        damping = std::max(least_damping, damping / 5);
        ++result.steps;
        if (!is_better) break;
    }
    result.is_converged = result.steps < most_steps;
    result.knots = lines.knots();
    return result;
}

}  // namespace batten::surface_fitting
