#include "make/fit_surface/front_jump.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "num/cox_de_boor.hpp"
#include "shape/surface/sides.hpp"

namespace batten::surface_fitting {
namespace {

constexpr int most_turns = 6;
constexpr int cells_aside = 2;      // that a row's jump may move in one turn
constexpr double margin = 0.1;      // of a cell, between the line and the nodes beside it
constexpr double together = 1e-14;  // of the domain
constexpr int most_projections = 300;

std::size_t cell_at(std::span<const double> lines, double x) {
    const auto inside = lines.subspan(1, lines.size() - 2);
    return static_cast<std::size_t>(std::upper_bound(inside.begin(), inside.end(), x) -
                                    inside.begin());
}

/// A jump through all rows: the surface on both sides of it, each continued over the other.
class Sides {
public:
    Sides(const Nodes& nodes, const FrontShape& shape, const std::vector<double>& theta,
          const std::vector<double>& coefficients, int front)
        : nodes_(nodes), shape_(shape), theta_(theta), c_(coefficients), front_(front),
          across_(surfaces::side_of(
              BSplineBasis::over(
                  even_places(shape.domain.y, static_cast<std::size_t>(shape.y_strips) + 1), 3),
              nodes.y)) {}

    /// The cell between whose nodes row s jumps best, near `cell`.
    std::size_t best_cell(std::size_t s, std::size_t cell) const {
        const std::size_t lowest = cell > cells_aside ? cell - cells_aside : 0;
        const std::size_t highest = std::min(nodes_.x.size() - 2, cell + cells_aside);
        const std::vector<double> knots = knots_at(s), c = coefficients_at(s);
        std::size_t best = cell;
        double least = std::numeric_limits<double>::infinity(), sum = 0;
        for (std::size_t r = lowest + 1; r <= highest; ++r) sum += misfit(knots, c, r, s, true);
        for (std::size_t k = lowest; k <= highest; ++k) {
            if (k > lowest) sum += misfit(knots, c, k, s, false) - misfit(knots, c, k, s, true);
            if (sum < least || (sum == least && k == cell)) {
                least = sum;
                best = k;
            }
        }
        return best;
    }

private:
    std::vector<double> knots_at(std::size_t s) const {
        std::vector<double> knots(jump_lines, shape_.domain.x.lo);
        const LinesAt at = lines_at(shape_, theta_, nodes_.y[s]);
        knots.insert(knots.end(), at.x.begin(), at.x.end());
        knots.insert(knots.end(), jump_lines, shape_.domain.x.hi);
        return knots;
    }
    std::vector<double> coefficients_at(std::size_t s) const {
        const std::size_t q = static_cast<std::size_t>(shape_.y_functions());
        std::vector<double> c(static_cast<std::size_t>(shape_.x_functions()), 0.0);
        for (std::size_t i = 0; i < c.size(); ++i) {
            for (std::size_t j = 0; j < jump_lines; ++j) {
                c[i] += across_.at(s)[j] * c_[i * q + across_.first[s] + j];
            }
        }
        return c;
    }
    /// The squared residual of a node, should it lie left (right) of the jump.
    double misfit(const std::vector<double>& knots, const std::vector<double>& c, std::size_t r,
                  std::size_t s, bool is_right) const {
        const std::size_t first_line = jump_lines + shape_.line_at(front_);
        const std::size_t span = is_right ? first_line + jump_lines - 1 : first_line - 1;
        double values[jump_lines];
        num::basis_values(knots, span, jump_lines, nodes_.x[r], values);
        const std::size_t at = r * nodes_.y.size() + s;
        double e = nodes_.z[at];
        for (std::size_t j = 0; j < jump_lines; ++j) e -= values[j] * c[span + 1 - jump_lines + j];
        const double weight = nodes_.x_weight[r] * nodes_.y_weight[s];
        return weight * weight * (nodes_.is_full() ? 1 : nodes_.cell_factor_sq[at]) * e * e;
    }

    const Nodes& nodes_;
    const FrontShape& shape_;
    const std::vector<double>& theta_;
    const std::vector<double>& c_;
    int front_;
    num::TensorSide across_;
};

/// phi through the cells, as far as it can: projections on the cells and on the splines by turns.
/// Source: [Bregman1967].
void pass_through(const Nodes& nodes, const FrontShape& shape, const std::vector<std::size_t>& cells,
                  std::vector<double>& theta, int front) {
    const Eigen::Index rows = static_cast<Eigen::Index>(nodes.y.size());
    const SplineFunction start = front_curve(shape, theta, front);
    const num::TensorSide side = surfaces::side_of(
        BSplineBasis({start.knots().begin(), start.knots().end()}, start.degree()), nodes.y);
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, shape.front_values());
    for (Eigen::Index s = 0; s < rows; ++s) {
        const std::size_t at = static_cast<std::size_t>(s);
        for (int j = 0; j < side.order; ++j) {
            a(s, static_cast<Eigen::Index>(side.first[at]) + j) = side.at(at)[j];
        }
    }
    Eigen::MatrixXd normal = a.transpose() * a;
    normal.diagonal().array() += 1e-12 * normal.trace();
    const Eigen::LDLT<Eigen::MatrixXd> solver(normal);
    Eigen::Map<Eigen::VectorXd> phi(theta.data() + shape.phi_at(front), shape.front_values());
    for (int round = 0; round < most_projections; ++round) {
        Eigen::VectorXd wanted = a * phi;
        bool is_inside = true;
        for (Eigen::Index s = 0; s < rows; ++s) {
            const std::size_t cell = cells[static_cast<std::size_t>(s)];
            const double lo = nodes.x[cell], hi = nodes.x[cell + 1];
            const double room = margin * (hi - lo), at = wanted[s];
            is_inside = is_inside && lo + 0.5 * room < at && at < hi - 0.5 * room;
            wanted[s] = std::clamp(at, lo + room, hi - room);
        }
        if (is_inside) return;
        phi = solver.solve(a.transpose() * wanted);
    }
}

}  // namespace

std::vector<double> jump_at(const Nodes& nodes, const FrontShape& shape,
                            std::vector<double> theta, int front) {
    for (std::size_t g = 0; g + 1 < jump_lines; ++g) {
        theta[shape.gaps_at(front) + g] = std::log(together * shape.domain.x.length());
    }
    const SplineFunction phi = front_curve(shape, theta, front);
    std::vector<std::size_t> cells;
    for (const double y : nodes.y) cells.push_back(cell_at(nodes.x, phi(y)));
    std::vector<double> best = theta;
    double least = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < most_turns; ++turn) {
        const FrontState state = front_state(nodes, shape, theta, Slopes::none);
        if (!std::isfinite(state.delta2)) break;
        if (state.delta2 < least) {
            least = state.delta2;
            best = theta;
        }
        const Sides sides(nodes, shape, theta, state.coefficients, front);
        const std::vector<std::size_t> before = cells;
        for (std::size_t s = 0; s < cells.size(); ++s) cells[s] = sides.best_cell(s, cells[s]);
        if (turn > 0 && cells == before) break;
        pass_through(nodes, shape, cells, theta, front);
    }
    return best;
}

}  // namespace batten::surface_fitting
