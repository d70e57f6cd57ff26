#include "make/fit_surface/compressed.hpp"

#include <algorithm>
#include <cmath>

#include "num/tensor.hpp"

namespace batten::surface_fitting {
namespace {

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
    /// Coefficients for the fine splines of those for the coarse ones, count rows.
    std::vector<double> refined(const std::vector<double>& rows) const {
        const std::size_t count = rows.size() / coarse;
        std::vector<double> result(count * fine, 0.0);
        for (std::size_t r = 0; r < count; ++r) {
            for (std::size_t i = 0; i < coarse; ++i) {
                double* const to = result.data() + r * fine + first[i];
                const double value = rows[r * coarse + i];
                for (std::size_t j = 0; j < weights[i].size(); ++j) to[j] += weights[i][j] * value;
            }
        }
        return result;
    }
};

Inclusion inclusion_of(const BSplineBasis& coarse, const BSplineBasis& fine) {
    Inclusion all{coarse.size(), fine.size(), {}, {}};
    std::vector<double> more;
    std::set_difference(fine.breaks().begin(), fine.breaks().end(), coarse.breaks().begin(),
                        coarse.breaks().end(), std::back_inserter(more));
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        std::vector<double> unit(coarse.size(), 0.0);
        unit[i] = 1;
        const SplineFunction one({coarse.knots().begin(), coarse.knots().end()}, unit,
                                 coarse.degree());
        const SplineFunction same = more.empty() ? one : insert_knots(one, more);
        const std::span<const double> c = same.coefficients();
        std::size_t from = 0, to = c.size();
        while (from + 1 < to && c[from] == 0) ++from;
        while (to > from + 1 && c[to - 1] == 0) --to;
        all.first.push_back(from);
        all.weights.emplace_back(c.begin() + static_cast<std::ptrdiff_t>(from),
                                 c.begin() + static_cast<std::ptrdiff_t>(to));
    }
    return all;
}

std::vector<double> transposed(const std::vector<double>& m, std::size_t rows, std::size_t columns) {
    std::vector<double> result(m.size());
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) result[j * rows + i] = m[i * columns + j];
    }
    return result;
}

/// G = A^T A of one direction, full.
std::vector<double> gram_of(const Axis& axis) {
    const num::TensorSide& side = axis.weighted();
    const std::size_t n = axis.functions();
    std::vector<double> gram(n * n, 0.0);
    for (std::size_t r = 0; r < side.places(); ++r) {
        for (int i = 0; i < side.order; ++i) {
            for (int j = 0; j < side.order; ++j) {
                gram[(side.first[r] + static_cast<std::size_t>(i)) * n + side.first[r] +
                     static_cast<std::size_t>(j)] += side.at(r)[i] * side.at(r)[j];
            }
        }
    }
    return gram;
}

/// rows x n times a band matrix n x n of half-width `band`.
std::vector<double> times_band(const std::vector<double>& rows, const std::vector<double>& matrix,
                               std::size_t n, std::size_t band) {
    std::vector<double> result(rows.size(), 0.0);
    for (std::size_t r = 0; r < rows.size() / n; ++r) {
        for (std::size_t k = 0; k < n; ++k) {
            const double factor = rows[r * n + k];
            const std::size_t from = k > band ? k - band : 0, to = std::min(n, k + band + 1);
            for (std::size_t j = from; j < to; ++j) {
                result[r * n + j] += factor * matrix[k * n + j];
            }
        }
    }
    return result;
}

/// The measure of every strip along one direction: `products` are those of the heights' lines with
/// the splines across, c the coefficients with the direction first.
std::vector<double> strips_along(const Axis& along, const Axis& across,
                                 std::vector<double> products, const std::vector<double>& c,
                                 std::span<const double> lines) {
    const std::size_t q = across.functions(), count = lines.size();
    const std::vector<double> image =
        times_band(c, gram_of(across), q, static_cast<std::size_t>(across.basis().degree()));
    const num::TensorSide& side = along.weighted();
    for (std::size_t r = 0; r < count; ++r) {
        for (int i = 0; i < side.order; ++i) {
            const double value = side.at(r)[i];
            const double* const row =
                image.data() + (side.first[r] + static_cast<std::size_t>(i)) * q;
            for (std::size_t j = 0; j < q; ++j) products[r * q + j] -= value * row[j];
        }
    }
    std::vector<double> turned = transposed(products, count, q);
    across.forward_rows(turned, count);
    const std::span<const double> breaks = along.basis().breaks();
    std::vector<double> strips(breaks.size() - 1, 0.0);
    const auto inside = breaks.subspan(1, breaks.size() - 2);
    std::vector<double> sums(count, 0.0);
    for (std::size_t j = 0; j < q; ++j) {
        for (std::size_t r = 0; r < count; ++r) sums[r] += turned[j * count + r] * turned[j * count + r];
    }
    for (std::size_t r = 0; r < count; ++r) {
        strips[static_cast<std::size_t>(std::upper_bound(inside.begin(), inside.end(), lines[r]) -
                                        inside.begin())] += sums[r] / static_cast<double>(q);
    }
    return strips;
}

/// Every row by itself: what makes products with one side only.
num::TensorSide separate(std::span<const double> weights) {
    num::TensorSide side{1, weights.size(), {}, {weights.begin(), weights.end()}};
    for (std::size_t r = 0; r < weights.size(); ++r) side.first.push_back(r);
    return side;
}

}  // namespace

std::unique_ptr<Compressed> Compressed::of(const Nodes& nodes, int degree, int strips) {
    const auto basis = [&](std::span<const double> lines) {
        return BSplineBasis::over(halved({lines.front(), lines.back()}, strips), degree);
    };
    const BSplineBasis x = basis(nodes.x), y = basis(nodes.y);
    if (!is_determined(x, nodes.x) || !is_determined(y, nodes.y)) return nullptr;
    return std::unique_ptr<Compressed>(new Compressed(
        nodes, Axis(x, nodes.x, nodes.x_weight, nodes.x), Axis(y, nodes.y, nodes.y_weight, nodes.y)));
}

Compressed::Compressed(const Nodes& nodes, Axis x, Axis y)
    : nodes_(nodes), x_(std::move(x)), y_(std::move(y)) {
    const std::size_t m = nodes.x.size(), n = nodes.y.size();
    // Rows by the splines in y, and from these what the splines in x make of them.
    rows_.assign(m * y_.functions(), 0.0);
    const num::TensorSide each_row = separate(nodes.x_weight);
    num::Tensor(each_row, y_.normal()).contract(nodes.z, {0, m}, rows_);
    both_.assign(x_.functions() * y_.functions(), 0.0);
    const num::TensorSide& a = x_.weighted();
    for (std::size_t r = 0; r < m; ++r) {
        for (int i = 0; i < a.order; ++i) {
            double* const to = both_.data() +
                               (a.first[r] + static_cast<std::size_t>(i)) * y_.functions();
            for (std::size_t j = 0; j < y_.functions(); ++j) {
                to[j] += a.at(r)[i] * rows_[r * y_.functions() + j];
            }
        }
    }
    std::vector<double> columns(x_.functions() * n, 0.0);
    const num::TensorSide each_column = separate(nodes.y_weight);
    num::Tensor(x_.normal(), each_column).contract(nodes.z, {0, m}, columns);
    columns_ = transposed(columns, x_.functions(), n);
    finest_ = inverted(both_, x_, y_);
    double all = 0, explained = 0;
    for (std::size_t r = 0; r < m; ++r) {
        double sums[8] = {};
        const double* const row = nodes.z.data() + r * n;
        const double* const weight = nodes.y_weight.data();
        std::size_t s = 0;
        for (; s + 8 <= n; s += 8) {
            for (std::size_t l = 0; l < 8; ++l) {
                const double e = row[s + l] * weight[s + l];
                sums[l] += e * e;
            }
        }
        for (; s < n; ++s) sums[0] += row[s] * weight[s] * row[s] * weight[s];
        double sum = 0;
        for (const double part : sums) sum += part;
        all += sum * nodes.x_weight[r] * nodes.x_weight[r];
    }
    for (std::size_t k = 0; k < finest_.size(); ++k) explained += finest_[k] * both_[k];
    finest_delta2_ = all - explained;
    if (!(all <= safe_ratio * finest_delta2_)) {
        finest_delta2_ = misfit(nodes, x_, y_, finest_, std::nullopt).delta2;
    }
}

bool Compressed::holds(const std::vector<double>& x_breaks,
                       const std::vector<double>& y_breaks) const {
    const std::span<const double> x = x_.basis().breaks(), y = y_.basis().breaks();
    return std::includes(x.begin(), x.end(), x_breaks.begin(), x_breaks.end()) &&
           std::includes(y.begin(), y.end(), y_breaks.begin(), y_breaks.end());
}

void Compressed::fit(const Axis& x, const Axis& y, Solution& solution, Misfit& misfit) const {
    const Inclusion in_x = inclusion_of(x.basis(), x_.basis());
    const Inclusion in_y = inclusion_of(y.basis(), y_.basis());
    const std::size_t p = x.functions(), q = y.functions();
    const std::vector<double> half = in_y.reduced(both_);  // fine x by coarse y
    const std::vector<double> g = in_x.reduced(transposed(half, x_.functions(), q));  // q x p
    solution = {inverted(transposed(g, q, p), x, y)};
    const std::vector<double>& c = solution.coefficients;

    // The distance to the finest fit, in the norm of the weighted nodes.
    const std::vector<double> wide = in_y.refined(c);  // p x fine y
    const std::vector<double> fine = transposed(
        in_x.refined(transposed(wide, p, y_.functions())), y_.functions(), x_.functions());
    std::vector<double> gap(finest_.size());
    for (std::size_t k = 0; k < gap.size(); ++k) gap[k] = finest_[k] - fine[k];
    const std::size_t band = static_cast<std::size_t>(x.basis().degree());
    const std::vector<double> by_y = times_band(gap, gram_of(y_), y_.functions(), band);
    const std::vector<double> by_x =
        times_band(transposed(by_y, x_.functions(), y_.functions()), gram_of(x_), x_.functions(),
                   band);
    const std::vector<double> image = transposed(by_x, y_.functions(), x_.functions());
    misfit = {};
    misfit.psi_is_missing = true;
    misfit.delta2 = finest_delta2_;
    for (std::size_t k = 0; k < gap.size(); ++k) misfit.delta2 += gap[k] * image[k];

    misfit.x_strips = strips_along(x, y, in_y.reduced(rows_), c, nodes_.x);
    misfit.y_strips = strips_along(y, x, in_x.reduced(columns_), transposed(c, p, q), nodes_.y);
}

}  // namespace batten::surface_fitting
