#include "make/fit_surface/front_model.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "make/fit_surface/axis.hpp"
#include "num/cox_de_boor.hpp"
#include "shape/surface/sides.hpp"

namespace batten::surface_fitting {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr int order = 4;
constexpr std::size_t most_knots = 32;  // 3 bundles of 6 lines, 4 beside, the ends
/// Ties between neighbouring coefficients, of the largest diagonal: for those without data.
constexpr double tie = 1e-11;

BSplineBasis across_basis(const FrontShape& shape) {
    return BSplineBasis::over(
        even_places(shape.domain.y, static_cast<std::size_t>(shape.y_strips) + 1), 3);
}

std::vector<double> with_ends(const std::vector<double>& lines, Interval domain) {
    std::vector<double> knots(order, domain.lo);
    knots.insert(knots.end(), lines.begin(), lines.end());
    knots.insert(knots.end(), order, domain.hi);
    return knots;
}

std::size_t span_in(const std::vector<double>& knots, double x) {
    const auto inside = knots.begin() + order;
    const auto end = knots.end() - order;
    return static_cast<std::size_t>(std::upper_bound(inside, end, x) - knots.begin()) - 1;
}

/// dS/dt_l at x for a spline with coefficients c over `knots`: see docs/surfaces.md.
double knot_slope(const std::vector<double>& knots, const double* c, std::size_t l, double x) {
    if (x < knots[l + 1 - order] || x > knots[l + order - 1]) return 0;
    double longer[most_knots];
    const std::size_t count = knots.size() + 1;
    std::copy_n(knots.begin(), l + 1, longer);
    std::copy(knots.begin() + static_cast<std::ptrdiff_t>(l), knots.end(), longer + l + 1);
    const std::size_t span = static_cast<std::size_t>(
        std::upper_bound(longer + order, longer + count - order, x) - longer) - 1;
    double values[order];
    num::basis_values({longer, count}, span, order, x, values);
    double sum = 0;
    for (std::size_t j = 0; j < order; ++j) {
        const std::size_t i = span + 1 - order + j;
        if (i + order < l + 1 || i > l || i == 0) continue;
        const double width = knots[i + order - 1] - knots[i];
        if (width > 0) sum += (c[i - 1] - c[i]) / width * values[j];
    }
    return sum;
}

/// One row of nodes: its splines in x.
struct FrontRow {
    std::vector<double> knots;
    LinesAt lines;
    double y_values[order];
    std::size_t y_first = 0;
};

/// Weighted sums that do not depend on the coefficients' number of rows.
class FrontSystem {
public:
    FrontSystem(const Nodes& nodes, const FrontShape& shape, const std::vector<double>& theta)
        : nodes_(nodes), shape_(shape), y_side_(surfaces::side_of(across_basis(shape), nodes.y)) {
        const int p = shape.coefficients();
        normal_ = Matrix::Zero(p, p);
        right_ = Vector::Zero(p);
        for (std::size_t s = 0; s < nodes.y.size() && is_inside_; ++s) add_row(s, theta);
    }

    bool is_inside() const { return is_inside_; }

    /// Whether every spline in x has a node of its own, taken over all rows: lines closer together
    /// leave coefficients to chance, and the surface swings between the nodes.
    bool is_supported() const {
        for (std::size_t i = 0; i < static_cast<std::size_t>(shape_.x_functions()); ++i) {
            std::size_t nodes = 0;
            for (const FrontRow& row : rows_) {
                const auto from = std::upper_bound(nodes_.x.begin(), nodes_.x.end(), row.knots[i]);
                const auto to =
                    std::lower_bound(from, nodes_.x.end(), row.knots[i + order]);
                nodes += static_cast<std::size_t>(to - from);
            }
            if (nodes < rows_.size()) return false;
        }
        return true;
    }

    void solve() {
        const double scale = tie * normal_.diagonal().maxCoeff();
        const int q = shape_.y_functions();
        for (int i = 0; i + 1 < shape_.x_functions(); ++i) {
            for (int j = 0; j < q; ++j) {
                const int a = i * q + j, b = a + q;
                normal_(a, a) += scale;
                normal_(b, b) += scale;
                normal_(a, b) -= scale;
                normal_(b, a) -= scale;
            }
        }
        solver_.compute(normal_);
        c_ = solver_.solve(right_);
    }

    FrontState state(Slopes slopes) {
        const int n = shape_.parameters(), p = shape_.coefficients();
        Matrix own = Matrix::Zero(n, n), across = Matrix::Zero(p, n);
        Vector gradient = Vector::Zero(n), slope(n);
        FrontState result;
        for (std::size_t s = 0; s < rows_.size(); ++s) {
            const std::vector<double> c = row_coefficients(s);
            for (std::size_t r = 0; r < nodes_.x.size(); ++r) {
                const double weight = weight_of(r, s);
                if (weight == 0) continue;
                double a[order];
                const std::size_t first = splines(s, r, a);
                double e = nodes_.z[r * nodes_.y.size() + s];
                for (std::size_t i = 0; i < order; ++i) e -= a[i] * c[first + i];
                result.delta2 += weight * weight * e * e;
                if (slopes == Slopes::none || !fill_slope(s, r, c, slope)) continue;
                slope *= weight;
                own.selfadjointView<Eigen::Lower>().rankUpdate(slope);
                gradient -= weight * e * slope;
                for (std::size_t i = 0; i < order; ++i) {
                    for (std::size_t j = 0; j < order; ++j) {
                        const double value = weight * a[i] * rows_[s].y_values[j];
                        across.row(index(first + i, rows_[s].y_first + j)) +=
                            value * slope.transpose();
                    }
                }
            }
        }
        result.coefficients.assign(c_.data(), c_.data() + p);
        if (slopes == Slopes::none) return result;
        own = own.selfadjointView<Eigen::Lower>();
        const Matrix normal = own - across.transpose() * solver_.solve(across);
        result.gradient.assign(gradient.data(), gradient.data() + n);
        result.normal.assign(normal.data(), normal.data() + n * n);
        return result;
    }

private:
    int index(std::size_t i, std::size_t j) const {
        return static_cast<int>(i) * shape_.y_functions() + static_cast<int>(j);
    }
    double weight_of(std::size_t r, std::size_t s) const {
        const double weight = nodes_.x_weight[r] * nodes_.y_weight[s];
        if (nodes_.is_full()) return weight;
        return weight * std::sqrt(nodes_.cell_factor_sq[r * nodes_.y.size() + s]);
    }
    std::size_t splines(std::size_t s, std::size_t r, double* a) const {
        const std::size_t span = span_in(rows_[s].knots, nodes_.x[r]);
        num::basis_values(rows_[s].knots, span, order, nodes_.x[r], a);
        return span + 1 - order;
    }

    void add_row(std::size_t s, const std::vector<double>& theta) {
        FrontRow row;
        row.lines = lines_at(shape_, theta, nodes_.y[s]);
        is_inside_ = row.lines.is_inside;
        if (!is_inside_) return;
        row.knots = with_ends(row.lines.x, shape_.domain.x);
        row.y_first = y_side_.first[s];
        std::copy_n(y_side_.at(s), order, row.y_values);
        rows_.push_back(std::move(row));
        const FrontRow& at = rows_.back();
        Matrix h = Matrix::Zero(shape_.x_functions(), shape_.x_functions());
        Vector g = Vector::Zero(shape_.x_functions());
        for (std::size_t r = 0; r < nodes_.x.size(); ++r) {
            const double weight = weight_of(r, s);
            double a[order];
            const int first = static_cast<int>(splines(s, r, a));
            for (int i = 0; i < order; ++i) {
                g[first + i] += weight * weight * a[i] * nodes_.z[r * nodes_.y.size() + s];
                for (int j = 0; j < order; ++j) {
                    h(first + i, first + j) += weight * weight * a[i] * a[j];
                }
            }
        }
        for (std::size_t u = 0; u < order; ++u) {
            for (int i = 0; i < shape_.x_functions(); ++i) {
                const int at_u = index(static_cast<std::size_t>(i), at.y_first + u);
                right_[at_u] += at.y_values[u] * g[i];
                for (std::size_t v = 0; v < order; ++v) {
                    for (int j = 0; j < shape_.x_functions(); ++j) {
                        normal_(at_u, index(static_cast<std::size_t>(j), at.y_first + v)) +=
                            at.y_values[u] * at.y_values[v] * h(i, j);
                    }
                }
            }
        }
    }

    std::vector<double> row_coefficients(std::size_t s) const {
        std::vector<double> c(static_cast<std::size_t>(shape_.x_functions()), 0.0);
        for (std::size_t i = 0; i < c.size(); ++i) {
            for (std::size_t j = 0; j < order; ++j) {
                c[i] += rows_[s].y_values[j] * c_[index(i, rows_[s].y_first + j)];
            }
        }
        return c;
    }

    /// dS/dtheta at a node; false where it is zero.
    bool fill_slope(std::size_t s, std::size_t r, const std::vector<double>& c, Vector& slope) {
        const FrontRow& row = rows_[s];
        slope.setZero();
        bool is_any = false;
        for (std::size_t line = 0; line < row.lines.x.size(); ++line) {
            const double by_line = knot_slope(row.knots, c.data(), line + order, nodes_.x[r]);
            if (by_line == 0) continue;
            is_any = true;
            for (int k = 0; k < slope.size(); ++k) {
                slope[k] += by_line * row.lines.slopes[line * static_cast<std::size_t>(slope.size()) +
                                                       static_cast<std::size_t>(k)];
            }
        }
        return is_any;
    }

    const Nodes& nodes_;
    FrontShape shape_;
    num::TensorSide y_side_;
    std::vector<FrontRow> rows_;
    Matrix normal_;
    Vector right_, c_;
    Eigen::LDLT<Matrix> solver_;
    bool is_inside_ = true;
};

}  // namespace

FrontState front_state(const Nodes& nodes, const FrontShape& shape,
                       const std::vector<double>& theta, Slopes slopes) {
    FrontSystem system(nodes, shape, theta);
    if (!system.is_inside() || (shape.given.empty() && !system.is_supported())) {
        return {std::numeric_limits<double>::infinity(), {}, {}, {}};
    }
    system.solve();
    return system.state(slopes);
}

}  // namespace batten::surface_fitting
