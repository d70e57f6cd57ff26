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
constexpr std::size_t most_knots = 32;  // of a bundle: 6 lines, 2 beside, the ends
constexpr double least_room = 1e-9;  // of the domain, between lines and to the border
/// Ties between neighbouring coefficients, of the largest diagonal: for those without data.
constexpr double tie = 1e-11;

double logistic(double u) { return 1 / (1 + std::exp(-u)); }

BSplineBasis even_basis(Interval domain, int intervals) {
    return BSplineBasis::over(even_places(domain, static_cast<std::size_t>(intervals) + 1), 3);
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
        : nodes_(nodes), shape_(shape), y_side_(surfaces::side_of(
                                            even_basis(shape.domain.y, shape.y_strips), nodes.y)) {
        const int p = shape.coefficients();
        normal_ = Matrix::Zero(p, p);
        right_ = Vector::Zero(p);
        for (std::size_t s = 0; s < nodes.y.size() && is_inside_; ++s) add_row(s, theta);
    }

    bool is_inside() const { return is_inside_; }

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

/// Offsets of the bundle's lines from phi.
std::vector<double> offsets_of(const FrontShape& shape, const std::vector<double>& theta) {
    std::vector<double> offsets(static_cast<std::size_t>(shape.bundle), 0.0);
    const std::size_t first = static_cast<std::size_t>(shape.front_values());
    for (std::size_t i = 1; i < offsets.size(); ++i) {
        offsets[i] = offsets[i - 1] + std::exp(theta[first + i - 1]);
    }
    const double half = 0.5 * offsets.back();
    for (double& offset : offsets) offset -= half;
    return offsets;
}

}  // namespace

/// Given lines: in order, or on top of each other.
LinesAt standing_lines(const FrontShape& shape, double y) {
    LinesAt at;
    const Interval x = shape.domain.x;
    const double room = least_room * x.length();
    double before = x.lo + room;
    for (const SplineFunction& line : shape.given) {
        at.x.push_back(line(y));
        at.is_inside = at.is_inside && before <= at.x.back() && at.x.back() <= x.hi - room;
        before = at.x.back();
    }
    return at;
}

LinesAt lines_at(const FrontShape& shape, const std::vector<double>& theta, double y) {
    if (!shape.given.empty()) return standing_lines(shape, y);
    const BSplineBasis basis = even_basis(shape.domain.y, shape.front_intervals);
    double values[order];
    basis.nonzero(y, 0, values);
    const std::size_t first = basis.span_of(y) + 1 - order;
    const std::size_t n = theta.size(), bundle = static_cast<std::size_t>(shape.bundle);
    const std::size_t gaps = static_cast<std::size_t>(shape.front_values());
    const std::vector<double> offsets = offsets_of(shape, theta);
    double phi = 0;
    for (std::size_t j = 0; j < order; ++j) phi += values[j] * theta[first + j];
    LinesAt at{std::vector<double>(bundle + 2), std::vector<double>((bundle + 2) * n, 0.0)};
    for (std::size_t i = 0; i < bundle; ++i) {
        double* const slope = at.slopes.data() + (i + 1) * n;
        at.x[i + 1] = phi + offsets[i];
        for (std::size_t j = 0; j < order; ++j) slope[first + j] = values[j];
        for (std::size_t g = 0; g + 1 < bundle; ++g) {
            slope[gaps + g] = std::exp(theta[gaps + g]) * ((g < i ? 1 : 0) - 0.5);
        }
    }
    const Interval x = shape.domain.x;
    const double left = logistic(theta[n - 2]), right = logistic(theta[n - 1]);
    at.x.front() = x.lo + left * (at.x[1] - x.lo);
    at.x.back() = at.x[bundle] + right * (x.hi - at.x[bundle]);
    for (std::size_t k = 0; k + 2 < n; ++k) {
        at.slopes[k] = left * at.slopes[n + k];
        at.slopes[(bundle + 1) * n + k] = (1 - right) * at.slopes[bundle * n + k];
    }
    at.slopes[n - 2] = left * (1 - left) * (at.x[1] - x.lo);
    at.slopes[(bundle + 2) * n - 1] = right * (1 - right) * (x.hi - at.x[bundle]);
    double before = x.lo;
    const double room = least_room * x.length();
    for (std::size_t i = 0; i < at.x.size(); ++i) {
        const bool is_border = i == 0 || i + 1 == at.x.size() || i == 1;
        at.is_inside = at.is_inside && at.x[i] >= before + (is_border ? room : 0);
        before = at.x[i];
    }
    at.is_inside = at.is_inside && before <= x.hi - room;
    return at;
}

FrontState front_state(const Nodes& nodes, const FrontShape& shape,
                       const std::vector<double>& theta, Slopes slopes) {
    FrontSystem system(nodes, shape, theta);
    if (!system.is_inside()) return {std::numeric_limits<double>::infinity(), {}, {}, {}};
    system.solve();
    return system.state(slopes);
}

CurvedKnotSurface front_surface(const FrontShape& shape, const std::vector<double>& theta,
                                const std::vector<double>& coefficients) {
    std::vector<SplineFunction> y_lines;
    const std::vector<double> breaks =
        even_places(shape.domain.y, static_cast<std::size_t>(shape.y_strips) + 1);
    for (std::size_t j = 1; j + 1 < breaks.size(); ++j) {
        y_lines.emplace_back(std::vector<double>{shape.domain.x.lo, shape.domain.x.hi},
                             std::vector<double>{breaks[j]}, 0);
    }
    if (!shape.given.empty()) {
        return {3, shape.domain, shape.given, std::move(y_lines), coefficients};
    }
    const BSplineBasis basis = even_basis(shape.domain.y, shape.front_intervals);
    const std::vector<double> knots(basis.knots().begin(), basis.knots().end());
    const std::vector<double> phi(theta.begin(), theta.begin() + shape.front_values());
    const std::vector<double> offsets = offsets_of(shape, theta);
    const auto line = [&](double offset, double share, double base) {
        std::vector<double> c = phi;
        for (double& value : c) value = base + share * (value + offset - base);
        return SplineFunction(knots, std::move(c), 3);
    };
    const std::size_t n = theta.size();
    std::vector<SplineFunction> x_lines{
        line(offsets.front(), logistic(theta[n - 2]), shape.domain.x.lo)};
    for (const double offset : offsets) x_lines.push_back(line(offset, 1, 0));
    x_lines.push_back(line(offsets.back(), 1 - logistic(theta[n - 1]), shape.domain.x.hi));
    return {3, shape.domain, std::move(x_lines), std::move(y_lines), coefficients};
}

std::vector<double> front_start(const FrontShape& shape, const Nodes& nodes,
                                const std::vector<double>& front, double width) {
    const BSplineBasis basis = even_basis(shape.domain.y, shape.front_intervals);
    const num::TensorSide side = surfaces::side_of(basis, nodes.y);
    Matrix a = Matrix::Zero(static_cast<int>(nodes.y.size()), static_cast<int>(basis.size()));
    Vector b(static_cast<int>(nodes.y.size()));
    for (std::size_t s = 0; s < nodes.y.size(); ++s) {
        for (int j = 0; j < order; ++j) {
            a(static_cast<int>(s), static_cast<int>(side.first[s]) + j) = side.at(s)[j];
        }
        b[static_cast<int>(s)] = front[s];
    }
    Matrix normal = a.transpose() * a;
    normal.diagonal().array() += 1e-12 * normal.trace();
    const Vector phi = normal.ldlt().solve(a.transpose() * b);
    std::vector<double> theta(phi.data(), phi.data() + phi.size());
    theta.insert(theta.end(), static_cast<std::size_t>(shape.bundle) - 1,
                 std::log(width / (shape.bundle - 1)));
    theta.insert(theta.end(), 2, 0.0);
    return theta;
}

std::vector<double> steepest_path(const Nodes& nodes) {
    const std::size_t m = nodes.x.size(), n = nodes.y.size();
    const Interval domain{nodes.x.front(), nodes.x.back()};
    const double height = nodes.y.back() - nodes.y.front();
    constexpr double free_slope = 2.5;  // domain widths a height, not charged
    Matrix steep = Matrix::Zero(static_cast<int>(n), static_cast<int>(m));
    for (std::size_t s = 0; s < n; ++s) {
        for (std::size_t r = 2; r + 2 < m; ++r) {
            const auto z = [&](std::size_t i) { return nodes.z[i * n + s]; };
            steep(static_cast<int>(s), static_cast<int>(r)) =
                std::fabs(2 * (z(r + 2) - z(r - 2)) + z(r + 1) - z(r - 1)) /
                (nodes.x[r + 2] - nodes.x[r - 2]);
        }
    }
    const double charge = steep.maxCoeff();
    Matrix best = steep;
    std::vector<std::size_t> from(n * m, 0);
    for (std::size_t s = 1; s < n; ++s) {
        const double reach =
            free_slope * (nodes.y[s] - nodes.y[s - 1]) / height * domain.length();
        for (std::size_t r = 0; r < m; ++r) {
            double most = -std::numeric_limits<double>::infinity();
            for (std::size_t q = 0; q < m; ++q) {
                const double step = std::fabs(nodes.x[r] - nodes.x[q]);
                const double beyond = std::max(0.0, step - reach) / reach;
                const double value = best(static_cast<int>(s) - 1, static_cast<int>(q)) -
                                     charge * beyond * beyond - 1e-3 * charge * step / reach;
                if (value <= most) continue;
                most = value;
                from[s * m + r] = q;
            }
            best(static_cast<int>(s), static_cast<int>(r)) += most;
        }
    }
    int last = 0;
    best.row(static_cast<int>(n) - 1).maxCoeff(&last);
    std::vector<double> path(n);
    std::size_t at = static_cast<std::size_t>(last);
    for (std::size_t s = n; s-- > 0;) {
        // The centre of the steepness around the place is finer than a cell.
        double sum = 0, moment = 0;
        for (std::size_t r = at >= 3 ? at - 3 : 0; r <= std::min(m - 1, at + 3); ++r) {
            const double value = steep(static_cast<int>(s), static_cast<int>(r));
            sum += value * value;
            moment += value * value * nodes.x[r];
        }
        path[s] = sum > 0 ? moment / sum : nodes.x[at];
        at = from[s * m + at];
    }
    return path;
}

}  // namespace batten::surface_fitting
