#include <algorithm>
#include <cmath>
#include <limits>

#include "make/fit_surface/moved_lines.hpp"
#include "make/fit_surface/solve.hpp"
#include "num/cox_de_boor.hpp"

namespace batten::surface_fitting {
namespace {

/// Lines, the best coefficients for them, what they leave.
struct LinesState {
    KnotPair knots;
    std::vector<Axis> axes;
    std::vector<double> c;
    double delta2 = std::numeric_limits<double>::infinity();
};

std::span<const double> lines_of(const Nodes& nodes, std::size_t side) {
    return side == 0 ? nodes.x : nodes.y;
}

LinesState state_of(const Nodes& nodes, KnotPair knots, int degree) {
    LinesState state;
    state.knots = std::move(knots);
    const std::vector<double> used[2] = {nodes.used_x(), nodes.used_y()};
    for (std::size_t side = 0; side < 2; ++side) {
        BSplineBasis basis(state.knots[side], degree);
        if (!is_determined(basis, used[side])) return state;
        state.axes.emplace_back(std::move(basis), lines_of(nodes, side),
                                side == 0 ? nodes.x_weight : nodes.y_weight, used[side]);
    }
    state.c = solve(nodes, state.axes[0], state.axes[1], Corrected::where_needed).coefficients;
    state.delta2 = misfit(nodes, state.axes[0], state.axes[1], state.c, std::nullopt).delta2;
    return state;
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

Moving moving_of(const Nodes& nodes, const LinesState& state, std::size_t side) {
    Moving m{&state.axes[side], &state.axes[1 - side], lines_of(nodes, side),
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

KnotModel model_of(const Moving& m, const std::vector<double>& t, std::size_t side) {
    const std::size_t order = static_cast<std::size_t>(m.along->basis().degree()) + 1;
    const std::size_t p = m.along->functions(), q = m.across->functions();
    KnotModel model;
    const std::vector<std::size_t> simple = simple_knots(t, static_cast<int>(order) - 1);
    for (const std::size_t l : simple) model.knots.push_back({side, l});
    const std::size_t count = model.knots.size();
    model.normal = num::SymmetricMatrix(count);
    const std::vector<double> gram = across_gram(*m.across);
    const num::TensorSide& a = m.along->weighted();
    std::vector<KnotSlope> slopes;
    std::vector<std::vector<double>> row_grams, parts, part_grams;
    for (const std::size_t l : simple) {
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

class GridLinesMoving : public MovableLines {
public:
    GridLinesMoving(const Nodes& nodes, KnotPair knots, int degree)
        : nodes_(nodes), degree_(degree), state_(state_of(nodes, std::move(knots), degree)) {}

    const KnotPair& knots() const override { return state_.knots; }
    double delta2() const override { return state_.delta2; }
    std::vector<KnotModel> models() const override {
        return {model_of(moving_of(nodes_, state_, 0), state_.knots[0], 0),
                model_of(moving_of(nodes_, state_, 1), state_.knots[1], 1)};
    }
    bool improves_by(KnotPair knots) override {
        LinesState next = state_of(nodes_, std::move(knots), degree_);
        if (!(next.delta2 < state_.delta2)) return false;
        state_ = std::move(next);
        return true;
    }

private:
    const Nodes& nodes_;
    int degree_;
    LinesState state_;
};

}  // namespace

MovedLines move_lines(const Nodes& nodes, KnotPair knots, int degree) {
    if (degree == 0) return {std::move(knots), 0, 0, true};
    GridLinesMoving lines(nodes, std::move(knots), degree);
    return descend(lines, degree);
}

}  // namespace batten::surface_fitting
