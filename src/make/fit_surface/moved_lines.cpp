#include "make/fit_surface/moved_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "make/fit_surface/solve.hpp"
#include "num/cox_de_boor.hpp"
#include "num/symmetric.hpp"

namespace batten::surface_fitting {
namespace {

constexpr int most_steps = 200;
constexpr double still = 1e-6;       // of delta2: a step that gains less is the last but one
constexpr double widest_step = 0.3;  // of the narrower strip beside a line
constexpr double first_damping = 1e-2, least_damping = 1e-8, most_damping = 1e6;

/// Lines, the best coefficients for them, what they leave.
struct LinesState {
    std::vector<double> knots[2];
    std::vector<Axis> axes;
    std::vector<double> c;
    double delta2 = std::numeric_limits<double>::infinity();
};

std::span<const double> lines_of(const Nodes& nodes, int side) {
    return side == 0 ? nodes.x : nodes.y;
}

LinesState state_of(const Nodes& nodes, std::vector<double> x_knots, std::vector<double> y_knots,
                    int degree) {
    LinesState state;
    state.knots[0] = std::move(x_knots);
    state.knots[1] = std::move(y_knots);
    const std::vector<double> used[2] = {nodes.used_x(), nodes.used_y()};
    for (int side = 0; side < 2; ++side) {
        BSplineBasis basis(state.knots[side], degree);
        if (!is_determined(basis, used[side])) return state;
        state.axes.emplace_back(std::move(basis), lines_of(nodes, side),
                                side == 0 ? nodes.x_weight : nodes.y_weight, used[side]);
    }
    state.c = solve(nodes, state.axes[0], state.axes[1], Corrected::where_needed).coefficients;
    state.delta2 = misfit(nodes, state.axes[0], state.axes[1], state.c, std::nullopt).delta2;
    return state;
}

/// Indices of the knots that may move.
std::vector<std::size_t> simple_knots(const std::vector<double>& t, int degree) {
    std::vector<std::size_t> simple;
    const std::size_t order = static_cast<std::size_t>(degree) + 1;
    for (std::size_t l = order; l + order < t.size(); ++l) {
        if (t[l - 1] < t[l] && t[l] < t[l + 1]) simple.push_back(l);
    }
    return simple;
}

/// One direction: c and the weighted residuals' products with the splines across, both with the
/// moved direction first.
struct Moving {
    const Axis* along;
    const Axis* across;
    std::span<const double> places, weights;
    std::vector<double> c;     ///< functions along x functions across
    std::vector<double> rest;  ///< places x functions across
};

Moving moving_of(const Nodes& nodes, const LinesState& state, int side) {
    Moving m{&state.axes[static_cast<std::size_t>(side)],
             &state.axes[static_cast<std::size_t>(1 - side)], lines_of(nodes, side),
             side == 0 ? nodes.x_weight : nodes.y_weight, {}, {}};
    const std::size_t p = m.along->functions(), q = m.across->functions();
    m.c.resize(p * q);
    for (std::size_t i = 0; i < p; ++i) {
        for (std::size_t j = 0; j < q; ++j) {
            m.c[i * q + j] = state.c[side == 0 ? i * q + j : j * p + i];
        }
    }
    m.rest.assign(m.places.size() * q, 0.0);
    const std::vector<double> e = residuals(nodes, state.axes[0], state.axes[1], state.c);
    const num::TensorSide& b = m.across->normal();
    const std::size_t ny = nodes.y.size(), order = static_cast<std::size_t>(b.order);
    for (std::size_t r = 0; r < m.places.size(); ++r) {
        for (std::size_t s = 0; s < b.places(); ++s) {
            const std::size_t node = side == 0 ? r * ny + s : s * ny + r;
            const double factor = nodes.is_full() ? 1 : nodes.cell_factor_sq[node];
            const double value = factor * e[node];
            double* const to = m.rest.data() + r * q + b.first[s];
            for (std::size_t j = 0; j < order; ++j) to[j] += value * b.at(s)[j];
        }
    }
    return m;
}

/// dS/dt_l at the places: a sum over order functions M of M(place) x row of differences.
struct KnotSlope {
    std::vector<double> rows;             ///< order x functions across
    std::vector<std::size_t> places;      ///< where some M is not 0
    std::vector<double> values;           ///< order numbers a place, weighted
};

KnotSlope slope_by(const Moving& m, const std::vector<double>& t, std::size_t l) {
    const std::size_t order = static_cast<std::size_t>(m.along->basis().degree()) + 1;
    const std::size_t q = m.across->functions();
    KnotSlope slope;
    for (std::size_t i = l + 1 - order; i <= l; ++i) {
        const double width = t[i + order - 1] - t[i];
        for (std::size_t j = 0; j < q; ++j) {
            slope.rows.push_back((m.c[(i - 1) * q + j] - m.c[i * q + j]) / width);
        }
    }
    std::vector<double> fine = t;
    fine.insert(fine.begin() + static_cast<std::ptrdiff_t>(l), t[l]);
    const double lo = t[l + 1 - order], hi = t[l + order - 1];
    double values[num::most_order];
    for (std::size_t r = 0; r < m.places.size(); ++r) {
        const double x = m.places[r];
        if (x < lo || x > hi) continue;
        std::size_t span = static_cast<std::size_t>(
            std::upper_bound(fine.begin(), fine.end(), x) - fine.begin()) - 1;
        while (!(fine[span] < fine[std::min(span + 1, fine.size() - 1)])) --span;
        num::basis_values(fine, span, static_cast<int>(order), x, values);
        slope.places.push_back(r);
        for (std::size_t k = 0; k < order; ++k) {
            // Function number (l + 1 - order) + k of the fine knots, if it lives on this span.
            const std::size_t function = l + 1 - order + k, first = span + 1 - order;
            const bool lives = first <= function && function <= span;
            slope.values.push_back(lives ? values[function - first] : 0);
        }
    }
    return slope;
}

/// Gram matrix of the splines across, times a row.
std::vector<double> across_gram(const Axis& across) {
    const std::size_t q = across.functions();
    std::vector<double> gram(q * q, 0.0);
    const num::TensorSide& b = across.weighted();
    for (std::size_t s = 0; s < b.places(); ++s) {
        for (int i = 0; i < b.order; ++i) {
            for (int j = 0; j < b.order; ++j) {
                gram[(b.first[s] + static_cast<std::size_t>(i)) * q + b.first[s] +
                     static_cast<std::size_t>(j)] += b.at(s)[i] * b.at(s)[j];
            }
        }
    }
    return gram;
}

/// rows (count x q) times a q x q matrix.
std::vector<double> times_matrix(const std::vector<double>& rows, const std::vector<double>& matrix,
                                 std::size_t q) {
    std::vector<double> result(rows.size(), 0.0);
    for (std::size_t i = 0; i < rows.size() / q; ++i) {
        for (std::size_t k = 0; k < q; ++k) {
            const double factor = rows[i * q + k];
            if (factor == 0) continue;
            for (std::size_t j = 0; j < q; ++j) result[i * q + j] += factor * matrix[k * q + j];
        }
    }
    return result;
}

double dot_product(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// sum over common places of M_a M_b weight^2: order x order.
double overlap(const Moving& m, const KnotSlope& a, const KnotSlope& b, std::size_t order,
               std::size_t q, const std::vector<double>& b_gram) {
    std::vector<double> common(order * order, 0.0);
    std::size_t ia = 0, ib = 0;
    while (ia < a.places.size() && ib < b.places.size()) {
        if (a.places[ia] < b.places[ib]) {
            ++ia;
        } else if (b.places[ib] < a.places[ia]) {
            ++ib;
        } else {
            const double weight = m.weights[a.places[ia]];
            for (std::size_t i = 0; i < order; ++i) {
                for (std::size_t j = 0; j < order; ++j) {
                    common[i * order + j] += weight * weight * a.values[ia * order + i] *
                                             b.values[ib * order + j];
                }
            }
            ++ia, ++ib;
        }
    }
    double sum = 0;
    for (std::size_t i = 0; i < order; ++i) {
        for (std::size_t j = 0; j < order; ++j) {
            if (common[i * order + j] == 0) continue;
            double row = 0;
            for (std::size_t k = 0; k < q; ++k) row += a.rows[i * q + k] * b_gram[j * q + k];
            sum += common[i * order + j] * row;
        }
    }
    return sum;
}

/// The local model of delta2 / 2 by the knots of one direction.
struct KnotModel {
    std::vector<std::size_t> knots;
    std::vector<double> gradient;
    num::SymmetricMatrix normal{0};
};

KnotModel model_of(const Moving& m, const std::vector<double>& t) {
    const std::size_t order = static_cast<std::size_t>(m.along->basis().degree()) + 1;
    const std::size_t p = m.along->functions(), q = m.across->functions();
    KnotModel model;
    model.knots = simple_knots(t, static_cast<int>(order) - 1);
    const std::size_t count = model.knots.size();
    model.normal = num::SymmetricMatrix(count);
    const std::vector<double> gram = across_gram(*m.across);
    const num::TensorSide& a = m.along->weighted();
    std::vector<KnotSlope> slopes;
    std::vector<std::vector<double>> row_grams, parts, part_grams;
    for (const std::size_t l : model.knots) {
        const KnotSlope slope = slope_by(m, t, l);
        double gradient = 0;
        std::vector<double> part(p * q, 0.0);  // R^-T A^T (weighted slope)
        for (std::size_t n = 0; n < slope.places.size(); ++n) {
            const std::size_t r = slope.places[n];
            const double weight = m.weights[r];
            for (std::size_t k = 0; k < order; ++k) {
                const double value = slope.values[n * order + k];
                if (value == 0) continue;
                const double* const row = slope.rows.data() + k * q;
                for (std::size_t j = 0; j < q; ++j) {
                    gradient -= weight * weight * value * row[j] * m.rest[r * q + j];
                }
                for (int i = 0; i < a.order; ++i) {
                    const double factor = a.at(r)[i] * weight * value;
                    double* const to = part.data() + (a.first[r] + static_cast<std::size_t>(i)) * q;
                    for (std::size_t j = 0; j < q; ++j) to[j] += factor * row[j];
                }
            }
        }
        m.along->forward_rows(part, q);
        model.gradient.push_back(gradient);
        row_grams.push_back(times_matrix(slope.rows, gram, q));
        part_grams.push_back(times_matrix(part, gram, q));
        parts.push_back(std::move(part));
        slopes.push_back(slope);
    }
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            model.normal(i, j) = model.normal(j, i) =
                overlap(m, slopes[i], slopes[j], order, q, row_grams[j]) -
                dot_product(parts[i], part_grams[j]);
        }
    }
    return model;
}

/// The step of one direction, each line kept away from its neighbours.
std::vector<double> step_of_knots(const KnotModel& model, const std::vector<double>& t,
                                  double damping) {
    num::SymmetricMatrix matrix = model.normal;
    double largest = 0;
    for (std::size_t i = 0; i < matrix.size; ++i) largest = std::max(largest, matrix(i, i));
    if (!(largest > 0)) return std::vector<double>(matrix.size, 0.0);
    for (std::size_t i = 0; i < matrix.size; ++i) {
        matrix(i, i) += damping * std::max(matrix(i, i), 1e-6 * largest);
    }
    std::vector<double> right = model.gradient;
    for (double& g : right) g = -g;
    std::vector<double> step =
        num::solve_positive(matrix, right).value_or(std::vector<double>(matrix.size, 0.0));
    for (std::size_t i = 0; i < step.size(); ++i) {
        const std::size_t l = model.knots[i];
        const double room = widest_step * std::min(t[l] - t[l - 1], t[l + 1] - t[l]);
        step[i] = std::clamp(step[i], -room, room);
    }
    return step;
}

std::vector<double> stepped(const KnotModel& model, std::vector<double> t, double damping) {
    const std::vector<double> step = step_of_knots(model, t, damping);
    for (std::size_t i = 0; i < step.size(); ++i) t[model.knots[i]] += step[i];
    return t;
}

}  // namespace

MovedLines move_lines(const Nodes& nodes, std::vector<double> x_knots, std::vector<double> y_knots,
                      int degree) {
    MovedLines result;
    result.moved = static_cast<int>(simple_knots(x_knots, degree).size() +
                                    simple_knots(y_knots, degree).size());
    LinesState state;
    if (degree > 0) state = state_of(nodes, x_knots, y_knots, degree);
    if (degree == 0 || result.moved == 0 || !std::isfinite(state.delta2)) {
        result.moved = 0;
        result.x_knots = std::move(x_knots);
        result.y_knots = std::move(y_knots);
        return result;
    }
    double damping = first_damping;
    int small_gains = 0;
    while (result.steps < most_steps && small_gains < 2 && damping <= most_damping) {
        const KnotModel x = model_of(moving_of(nodes, state, 0), state.knots[0]);
        const KnotModel y = model_of(moving_of(nodes, state, 1), state.knots[1]);
        bool is_better = false;
        for (; damping <= most_damping && !is_better; damping *= is_better ? 1 : 8) {
            LinesState next = state_of(nodes, stepped(x, state.knots[0], damping),
                                       stepped(y, state.knots[1], damping), degree);
            is_better = next.delta2 < state.delta2;
            if (!is_better) continue;
            small_gains = state.delta2 - next.delta2 <= still * state.delta2 ? small_gains + 1 : 0;
            state = std::move(next);
        }
        damping = std::max(least_damping, damping / 5);
        ++result.steps;
        if (!is_better) break;
    }
    result.is_converged = result.steps < most_steps;
    result.x_knots = std::move(state.knots[0]);
    result.y_knots = std::move(state.knots[1]);
    return result;
}

}  // namespace batten::surface_fitting
