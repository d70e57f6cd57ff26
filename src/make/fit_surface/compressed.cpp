#include "make/fit_surface/compressed.hpp"

#include <algorithm>
#include <cmath>

#include "num/lanes.hpp"
#include "num/rows.hpp"
#include "num/tensor.hpp"

namespace batten::surface_fitting {
namespace {

constexpr std::size_t rows_read = 16;
constexpr double safe_ratio = 1e6;  // of sum of squares to delta2: beyond, the nodes are read again

/// Breaks by halving, so that they are those of a search to the last bit.
std::vector<double> halved(Interval range, int strips) {
    std::vector<double> breaks{range.lo, range.hi};
    while (static_cast<int>(breaks.size()) - 1 < strips) {
        std::vector<double> finer{breaks.front()};
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
            finer.push_back(Interval{breaks[i], breaks[i + 1]}.middle());
            finer.push_back(breaks[i + 1]);
        }
        breaks = std::move(finer);
    }
    return breaks;
}

/// The coarse splines as sums of the fine ones.
struct Inclusion {
    std::size_t coarse, fine;
    std::vector<std::size_t> first;             ///< of every coarse spline: its first fine one
    std::vector<std::vector<double>> weights;

    /// The products with the coarse splines from those with the fine ones, count rows.
    std::vector<double> reduced(const std::vector<double>& rows) const {
        const std::size_t count = rows.size() / fine;
        std::vector<double> result(count * coarse);
        for (std::size_t r = 0; r < count; ++r) {
            for (std::size_t i = 0; i < coarse; ++i) {
                const double* const from = rows.data() + r * fine + first[i];
                double sum = 0;
                for (std::size_t j = 0; j < weights[i].size(); ++j) sum += weights[i][j] * from[j];
                result[r * coarse + i] = sum;
            }
        }
        return result;
    }
};

/// The coefficients of coarse spline i for the fine ones.
/// Source: [CohenLycheRiesenfeld1980, algorithm 1].
std::vector<double> refined(const BSplineBasis& coarse, std::size_t i, const BSplineBasis& fine) {
    const std::span<const double> t = coarse.knots(), u = fine.knots();
    const std::size_t order = static_cast<std::size_t>(coarse.degree()) + 1;
    std::vector<double> result(fine.size(), 0.0), a(order);
    for (std::size_t j = 0; j < fine.size(); ++j) {
        if (u[j] < t[i] || u[j + order] > t[i + order]) continue;
        for (std::size_t l = 0; l < order; ++l) {
            a[l] = t[i + l] <= u[j] && u[j] < t[i + l + 1] ? 1 : 0;
        }
        const auto share = [&](std::size_t first, std::size_t k) {
            const double width = t[first + k] - t[first];
            return width > 0 ? (u[j + k] - t[first]) / width : 0;
        };
        for (std::size_t k = 1; k < order; ++k) {
            for (std::size_t l = 0; l + k < order; ++l) {
                const double right = t[i + l + 1 + k] > t[i + l + 1] ? 1 - share(i + l + 1, k) : 0;
                a[l] = share(i + l, k) * a[l] + right * a[l + 1];
            }
        }
        result[j] = a[0];
    }
    return result;
}

Inclusion inclusion_of(const BSplineBasis& coarse, const BSplineBasis& fine) {
    Inclusion all{coarse.size(), fine.size(), {}, {}};
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        const std::vector<double> c = refined(coarse, i, fine);
        std::size_t from = 0, to = c.size();
        while (from + 1 < to && c[from] == 0) ++from;
        while (to > from + 1 && c[to - 1] == 0) --to;
        all.first.push_back(from);
        all.weights.emplace_back(c.begin() + static_cast<std::ptrdiff_t>(from),
                                 c.begin() + static_cast<std::ptrdiff_t>(to));
    }
    return all;
}

std::vector<double> transposed(const std::vector<double>& m, std::size_t rows,
                               std::size_t columns) {
    std::vector<double> result(m.size());
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) result[j * rows + i] = m[i * columns + j];
    }
    return result;
}

/// The sum of the squares of row[s] weights[s].
BATTEN_CLONES double weighted_square_sum(const double* row, std::span<const double> weights) {
    num::Lanes sums = {};
    std::size_t s = 0;
    for (; s + num::lanes <= weights.size(); s += num::lanes) {
        num::Lanes z, w;
        num::load(row + s, z);
        num::load(weights.data() + s, w);
        z *= w;
        sums += z * z;
    }
    double sum = num::sum_of(sums);
    for (; s < weights.size(); ++s) sum += row[s] * weights[s] * (row[s] * weights[s]);
    return sum;
}

/// (a b)(r, s) of the row r.
void add_row_products(const num::TensorSide& side, std::size_t r, std::span<const double> row,
                      std::vector<double>& to) {
    for (int i = 0; i < side.order; ++i) {
        const std::size_t at = side.first[r] + static_cast<std::size_t>(i);
        num::add_times(side.at(r)[i], row, std::span(to).subspan(at * row.size(), row.size()));
    }
}

}  // namespace

std::unique_ptr<Compressed> Compressed::of(const Nodes& nodes, int degree, int strips) {
    const auto basis = [&](std::span<const double> lines) {
        return BSplineBasis::over(halved({lines.front(), lines.back()}, strips), degree);
    };
    const BSplineBasis x = basis(nodes.x), y = basis(nodes.y);
    if (!is_determined(x, nodes.x) || !is_determined(y, nodes.y)) return nullptr;
    return std::unique_ptr<Compressed>(
        new Compressed(nodes, Axis(x, nodes.x, nodes.x_weight, nodes.x),
                       Axis(y, nodes.y, nodes.y_weight, nodes.y)));
}

Compressed::Compressed(const Nodes& nodes, Axis x, Axis y)
    : nodes_(nodes), x_(std::move(x)), y_(std::move(y)) {
    const double all = read_nodes();
    products_ = heights_;
    x_.forward_rows(heights_, y_.functions());
    y_.forward_columns(heights_);
    y_.forward_rows(x_lines_, nodes.x.size());
    x_.forward_rows(y_lines_, nodes.y.size());
    least_delta2_ = all - num::sum_of_squares(heights_);
    if (!(all <= safe_ratio * least_delta2_)) {
        least_delta2_ =
            misfit(nodes, x_, y_, inverted(products_, x_, y_), std::nullopt).delta2;
    }
}

double Compressed::read_nodes() {
    const std::size_t m = nodes_.x.size(), n = nodes_.y.size(), q = y_.functions();
    const num::Tensor tensor(x_.normal(), y_.normal(), num::Tensor::Use::products);
    heights_.assign(x_.functions() * q, 0.0);
    x_lines_.assign(q * m, 0.0);
    y_lines_.assign(x_.functions() * n, 0.0);
    std::vector<double> part(rows_read * q);
    double all = 0;
    for (std::size_t first = 0; first < m; first += rows_read) {
        const num::PlaceRange rows{first, std::min(m, first + rows_read)};
        std::fill(part.begin(), part.end(), 0.0);
        tensor.contract_apart(nodes_.z.subspan(first * n, rows.count() * n), rows, y_lines_, part);
        for (std::size_t r = rows.first; r < rows.last; ++r) {
            const double weight = nodes_.x_weight[r];
            all += weighted_square_sum(nodes_.z.data() + r * n, nodes_.y_weight) * weight * weight;
            const std::span<double> row = std::span(part).subspan((r - first) * q, q);
            for (double& value : row) value *= weight;
            add_row_products(x_.weighted(), r, row, heights_);
        }
        for (std::size_t j = 0; j < q; ++j) {
            for (std::size_t r = rows.first; r < rows.last; ++r) {
                x_lines_[j * m + r] = part[(r - first) * q + j];
            }
        }
    }
    for (std::size_t i = 0; i < x_.functions(); ++i) {
        for (std::size_t s = 0; s < n; ++s) y_lines_[i * n + s] *= nodes_.y_weight[s];
    }
    return all;
}

bool Compressed::has_break(Way way, double t) const {
    const std::span<const double> breaks = axis(way).basis().breaks();
    return std::binary_search(breaks.begin(), breaks.end(), t);
}

std::vector<double> Compressed::coordinates(Way way, const BSplineBasis& basis,
                                            std::size_t function) const {
    return axis(way).times_triangle(refined(basis, function, axis(way).basis()));
}

std::vector<double> Compressed::at_lines(Way way, std::span<const double> function) const {
    const std::vector<double> c = axis(way).solved(function);
    const num::TensorSide& side = axis(way).weighted();
    std::vector<double> values(side.places(), 0.0);
    for (std::size_t r = 0; r < values.size(); ++r) {
        for (int i = 0; i < side.order; ++i) {
            values[r] += side.at(r)[i] * c[side.first[r] + static_cast<std::size_t>(i)];
        }
    }
    return values;
}

SearchSpace::Image Compressed::image(Way way, std::span<const double> function) const {
    Image result;
    result.lines.assign(lines(across(way)).size(), 0.0);
    result.coordinates.assign(size(across(way)), 0.0);
    if (way == Way::x) {
        num::add_combination(function, y_lines_, result.lines);
        num::add_combination(function, heights_, result.coordinates);
    } else {
        num::add_combination(function, x_lines_, result.lines);
        num::add_dots(heights_, function, result.coordinates);
    }
    return result;
}

Solution Compressed::solution(const Axis& x, const Axis& y) const {
    const Inclusion in_x = inclusion_of(x.basis(), x_.basis());
    const Inclusion in_y = inclusion_of(y.basis(), y_.basis());
    const std::size_t p = x.functions(), q = y.functions();
    const std::vector<double> half = in_y.reduced(products_);  // fine x by coarse y
    const std::vector<double> g = in_x.reduced(transposed(half, x_.functions(), q));  // q x p
    return {inverted(transposed(g, q, p), x, y)};
}

}  // namespace batten::surface_fitting
