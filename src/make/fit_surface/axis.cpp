#include "make/fit_surface/axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "make/fit/whitney.hpp"
#include "num/clones.hpp"
#include "shape/surface/sides.hpp"

namespace batten::surface_fitting {
namespace {

/// Of the largest spline: enough for a regular triangle, too little to move what data determine.
constexpr double faint = 0x1p-20;
/// Rows turned to columns at a time.
constexpr std::size_t rows_turned = 32;

num::TensorSide times(const num::TensorSide& side, std::span<const double> weights) {
    num::TensorSide result = side;
    const std::size_t order = static_cast<std::size_t>(side.order);
    for (std::size_t r = 0; r < side.places(); ++r) {
        for (std::size_t j = 0; j < order; ++j) result.values[r * order + j] *= weights[r];
    }
    return result;
}

std::vector<fitting::Cell> lines_as_cells(const BSplineBasis& basis, std::span<const double> used) {
    fitting::Samples samples;
    samples.x = used;
    return fitting::cells_of(basis.knots(), basis.degree() + 1, samples);
}

/// (-1)^j binomial(order, j): the difference of order `order`.
std::vector<double> difference_row(int order, double scale) {
    std::vector<double> row(static_cast<std::size_t>(order) + 1);
    double choose = scale;
    for (int j = 0; j <= order; ++j) {
        row[static_cast<std::size_t>(j)] = j % 2 == 0 ? choose : -choose;
        choose = choose * (order - j) / (j + 1);
    }
    return row;
}

num::BandedQr triangle_of(const num::TensorSide& side) {
    num::BandedQr qr({side.order, static_cast<int>(side.functions), 0, 0});
    const std::size_t order = static_cast<std::size_t>(side.order);
    std::vector<double> rows;
    for (std::size_t r = 0; r < side.places();) {
        const std::size_t first = side.first[r];
        rows.clear();
        for (; r < side.places() && side.first[r] == first; ++r) {
            rows.insert(rows.end(), side.at(r), side.at(r) + order);
        }
        qr.absorb(static_cast<int>(first), rows.data(),
                  static_cast<int>(rows.size() / order));
    }
    qr.finish();
    return qr;
}

/// A row of a triangular solve of many right-hand sides.
struct Elimination {
    double* row;
    std::size_t width;
    const double* factors;  ///< of the other rows
    int others;
    double scale;
};

/// row = scale (row - sum of factors[l] others(l)), the others one after the other.
BATTEN_CLONES void eliminate(const Elimination& e, const double* others) {
    double* __restrict const row = e.row;
    const std::size_t width = e.width;
    if (e.others == 3) {
        const double a = e.factors[0], b = e.factors[1], c = e.factors[2], scale = e.scale;
        const double* const second = others + width;
        const double* const third = second + width;
        for (std::size_t k = 0; k < width; ++k) {
            row[k] = scale * (row[k] - a * others[k] - b * second[k] - c * third[k]);
        }
        return;
    }
    for (int l = 0; l < e.others; ++l) {
        const double factor = e.factors[l];
        const double* const other = others + static_cast<std::size_t>(l) * width;
        for (std::size_t k = 0; k < width; ++k) row[k] -= factor * other[k];
    }
    for (std::size_t k = 0; k < width; ++k) row[k] *= e.scale;
}

/// The triangle with faint differences between neighbouring coefficients.
num::BandedQr regular_triangle_of(const num::TensorSide& side) {
    const int functions = static_cast<int>(side.functions);
    const int width = std::min(side.order + 1, functions);
    num::BandedQr qr({width, functions, 0, 0});
    double largest = 0;
    for (const double value : side.values) largest = std::max(largest, std::fabs(value));
    const std::vector<double> difference = difference_row(width - 1, faint * largest);
    std::vector<double> row(static_cast<std::size_t>(width));
    std::size_t r = 0;
    for (int first = 0; first + width <= functions; ++first) {
        const bool is_last = first + width == functions;
        for (; r < side.places() && (static_cast<int>(side.first[r]) <= first || is_last); ++r) {
            std::fill(row.begin(), row.end(), 0.0);
            std::copy_n(side.at(r), side.order,
                        row.begin() + (static_cast<int>(side.first[r]) - first));
            qr.absorb(first, row.data(), 1);
        }
        std::copy(difference.begin(), difference.end(), row.begin());
        qr.absorb(first, row.data(), 1);
    }
    qr.finish();
    return qr;
}

}  // namespace

BSplineBasis basis_over(std::span<const double> breaks, int degree) {
    return BSplineBasis::over(breaks, degree);
}

std::size_t strip_of(const BSplineBasis& basis, double t) {
    const std::span<const double> inside = basis.breaks().subspan(1, basis.breaks().size() - 2);
    return static_cast<std::size_t>(std::upper_bound(inside.begin(), inside.end(), t) -
                                    inside.begin());
}

bool is_determined(const BSplineBasis& basis, std::span<const double> used) {
    const int functions = static_cast<int>(basis.size());
    return fitting::rank_of(lines_as_cells(basis, used), functions) == functions;
}

Axis::Axis(BSplineBasis basis, std::span<const double> lines, std::span<const double> weights,
           std::span<const double> used)
    : basis_(std::move(basis)), plain_(surfaces::side_of(basis_, lines)) {
    if (std::any_of(weights.begin(), weights.end(), [](double w) { return w != 1; })) {
        weighted_ = times(plain_, weights);
        normal_ = times(*weighted_, weights);
    }
    open_ = fitting::undetermined_coefficients(lines_as_cells(basis_, used),
                                               static_cast<int>(basis_.size()));
    const bool is_regular =
        open_.empty() || is_determined(basis_, lines);
    triangle_ = is_regular ? triangle_of(weighted()) : regular_triangle_of(weighted());
}

double Axis::spread() const {
    double largest = 0, smallest = std::fabs(triangle_.row(0)[0]);
    for (std::size_t j = 0; j < functions(); ++j) {
        const double size = std::fabs(triangle_.row(static_cast<int>(j))[0]);
        largest = std::max(largest, size);
        smallest = std::min(smallest, size);
    }
    return smallest > 0 ? largest / smallest : std::numeric_limits<double>::infinity();
}

std::vector<double> Axis::times_triangle(std::span<const double> c) const {
    std::vector<double> result(functions(), 0.0);
    for (std::size_t j = 0; j < result.size(); ++j) {
        const double* const r = triangle_.row(static_cast<int>(j));
        const std::size_t reach =
            std::min(static_cast<std::size_t>(triangle_.shape().width), result.size() - j);
        for (std::size_t l = 0; l < reach; ++l) result[j] += r[l] * c[j + l];
    }
    return result;
}

std::vector<double> Axis::solved(std::span<const double> c) const {
    std::vector<double> result(functions());
    triangle_.solve_for(c, result);
    return result;
}

void Axis::forward_rows(std::span<double> matrix, std::size_t width) const {
    const int n = static_cast<int>(functions()), band = triangle_.shape().width;
    std::vector<double> factors(static_cast<std::size_t>(band));
    for (int j = 0; j < n; ++j) {
        const int reach = std::min(band - 1, j);
        for (int l = reach; l > 0; --l) {
            factors[static_cast<std::size_t>(reach - l)] = triangle_.row(j - l)[l];
        }
        const double pivot = triangle_.row(j)[0];
        eliminate({matrix.data() + static_cast<std::size_t>(j) * width, width, factors.data(),
                   reach, pivot == 0 ? 0 : 1 / pivot},
                  matrix.data() + static_cast<std::size_t>(j - reach) * width);
    }
}

void Axis::invert_rows(std::span<double> matrix, std::size_t width) const {
    forward_rows(matrix, width);
    const int n = static_cast<int>(functions()), band = triangle_.shape().width;
    for (int j = n; j-- > 0;) {
        const double* const r = triangle_.row(j);
        double* const row = matrix.data() + static_cast<std::size_t>(j) * width;
        eliminate({row, width, r + 1, std::min(band, n - j) - 1, r[0] == 0 ? 0 : 1 / r[0]},
                  row + width);
    }
}

template <class Rows>
void Axis::by_columns(std::span<double> matrix, Rows work) const {
    const std::size_t n = functions(), count = matrix.size() / n;
    std::vector<double> turned(std::min(count, rows_turned) * n);
    for (std::size_t i = 0; i < count; i += rows_turned) {
        const std::size_t few = std::min(rows_turned, count - i);
        double* const from = matrix.data() + i * n;
        for (std::size_t k = 0; k < few; ++k) {
            for (std::size_t j = 0; j < n; ++j) turned[j * few + k] = from[k * n + j];
        }
        work(std::span(turned).first(n * few), few);
        for (std::size_t k = 0; k < few; ++k) {
            for (std::size_t j = 0; j < n; ++j) from[k * n + j] = turned[j * few + k];
        }
    }
}

void Axis::invert_columns(std::span<double> matrix) const {
    by_columns(matrix, [&](std::span<double> rows, std::size_t few) { invert_rows(rows, few); });
}

void Axis::forward_columns(std::span<double> matrix) const {
    by_columns(matrix, [&](std::span<double> rows, std::size_t few) { forward_rows(rows, few); });
}

}  // namespace batten::surface_fitting
