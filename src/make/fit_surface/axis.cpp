#include "make/fit_surface/axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "make/fit/whitney.hpp"
#include "num/clones.hpp"
#include "num/rows.hpp"
#include "shape/surface/sides.hpp"

namespace batten::surface_fitting {
namespace {

/// Of the largest spline: enough for a regular triangle, too little to move what data determine.
constexpr double faint = 0x1p-20;
/// Rows turned to columns at a time.
constexpr std::size_t rows_turned = 32;
/// Of the triangle's diagonal: from here on the products of the splines lose half of all digits.
constexpr double delicate_spread = 1e4;
/// The least singular value, columns of length 1, that is more than rounding of heights.
constexpr double least_singular = 1e-9;
constexpr int rounds_of_inverse = 3;
/// Of the largest coefficient of what is not seen: what is listed.
constexpr double part_of_unseen = 0.1;
/// Right-hand sides reduced at a time.
constexpr std::size_t columns_fitted = 8;

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

/// Some columns of a matrix with a row for every line, to be times the line's weight.
struct Columns {
    const double* matrix = nullptr;
    std::size_t stride = 0;
    int count = 0;
    std::span<const double> weights = {};

    void append(std::size_t line, std::vector<double>& row) const {
        for (int k = 0; k < count; ++k) {
            row.push_back(weights[line] * matrix[line * stride + static_cast<std::size_t>(k)]);
        }
    }
};

num::BandedQr triangle_of(const num::TensorSide& side, const Columns& columns) {
    num::BandedQr qr({side.order, static_cast<int>(side.functions), 0, columns.count});
    const std::size_t order = static_cast<std::size_t>(side.order);
    std::vector<double> rows;
    for (std::size_t r = 0; r < side.places();) {
        const std::size_t first = side.first[r];
        int count = 0;
        rows.clear();
        for (; r < side.places() && side.first[r] == first; ++r, ++count) {
            rows.insert(rows.end(), side.at(r), side.at(r) + order);
            columns.append(r, rows);
        }
        qr.absorb(static_cast<int>(first), rows.data(), count);
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

/// The row of faint differences that makes the triangle of a side regular.
std::vector<double> faint_row(const num::TensorSide& side) {
    const int width = std::min(side.order + 1, static_cast<int>(side.functions));
    double largest = 0;
    for (const double value : side.values) largest = std::max(largest, std::fabs(value));
    return difference_row(width - 1, faint * largest);
}

/// The triangle with faint differences between neighbouring coefficients.
num::BandedQr regular_triangle_of(const num::TensorSide& side, const Columns& columns) {
    const int functions = static_cast<int>(side.functions);
    const int width = std::min(side.order + 1, functions);
    num::BandedQr qr({width, functions, 0, columns.count});
    const std::vector<double> difference = faint_row(side);
    std::vector<double> row;
    std::size_t r = 0;
    for (int first = 0; first + width <= functions; ++first) {
        const bool is_last = first + width == functions;
        for (; r < side.places() && (static_cast<int>(side.first[r]) <= first || is_last); ++r) {
            row.assign(static_cast<std::size_t>(width), 0.0);
            std::copy_n(side.at(r), side.order,
                        row.begin() + (static_cast<int>(side.first[r]) - first));
            columns.append(r, row);
            qr.absorb(first, row.data(), 1);
        }
        row = difference;
        row.resize(static_cast<std::size_t>(width + columns.count), 0.0);
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
    : basis_(std::move(basis)), plain_(surfaces::side_of(basis_, lines)),
      weights_(weights.begin(), weights.end()) {
    if (std::any_of(weights.begin(), weights.end(), [](double w) { return w != 1; })) {
        weighted_ = times(plain_, weights);
        normal_ = times(*weighted_, weights);
    }
    open_ = fitting::undetermined_coefficients(lines_as_cells(basis_, used),
                                               static_cast<int>(basis_.size()));
    is_regular_ = open_.empty() || is_determined(basis_, lines);
    if (is_regular_) {
        triangle_ = triangle_of(weighted(), {});
        take_unseen_for_open();
    }
    if (!is_regular_) triangle_ = regular_triangle_of(weighted(), {});
}

/// Lines that formally determine all splines may do so by rounding only: the combination of splines
/// that they see least, by inverse iteration with columns of equal size.
void Axis::take_unseen_for_open() {
    const std::size_t n = functions();
    std::vector<double> scale(n), v(n);
    for (std::size_t j = 0; j < n; ++j) {
        scale[j] = std::sqrt(triangle_.column_sq(static_cast<int>(j)));
        v[j] = j % 3 == 1 ? -1 : 1;
    }
    double growth = 0;
    for (int round = 0; round < rounds_of_inverse; ++round) {
        const double norm = std::sqrt(num::sum_of_squares(v));
        for (std::size_t j = 0; j < n; ++j) v[j] *= scale[j] / norm;
        triangle_.solve_transposed(v);
        triangle_.solve_for(v, v);
        for (std::size_t j = 0; j < n; ++j) v[j] *= scale[j];
        growth = std::sqrt(num::sum_of_squares(v));
    }
    if (growth * least_singular * least_singular < 1) return;
    is_regular_ = false;
    double largest = 0;
    for (const double value : v) largest = std::max(largest, std::fabs(value));
    for (std::size_t j = 0; j < n; ++j) {
        const int open = static_cast<int>(j);
        const auto at = std::lower_bound(open_.begin(), open_.end(), open);
        const bool is_new = at == open_.end() || *at != open;
        if (is_new && std::fabs(v[j]) > part_of_unseen * largest) open_.insert(at, open);
    }
}

bool Axis::is_delicate() const { return spread() > delicate_spread; }

std::vector<double> Axis::fitted(std::span<const double> values, std::size_t width) const {
    std::vector<double> result(functions() * width), one(functions());
    for (std::size_t k = 0; k < width; k += columns_fitted) {
        const std::size_t count = std::min(columns_fitted, width - k);
        const Columns columns{values.data() + k, width, static_cast<int>(count), weights_};
        const num::BandedQr qr = is_regular_ ? triangle_of(weighted(), columns)
                                             : regular_triangle_of(weighted(), columns);
        for (std::size_t c = 0; c < count; ++c) {
            qr.solve(static_cast<int>(c), one);
            for (std::size_t j = 0; j < one.size(); ++j) result[j * width + k + c] = one[j];
        }
    }
    return result;
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

double Axis::mean_sq() const {
    return num::sum_of_squares(weighted().values) / static_cast<double>(functions());
}

std::vector<double> Axis::faint_part(const std::vector<double>& matrix, std::size_t width) const {
    std::vector<double> result(matrix.size(), 0.0);
    if (is_regular_) return result;
    const std::vector<double> row = faint_row(weighted());
    std::vector<double> difference(width);
    for (std::size_t first = 0; first + row.size() <= functions(); ++first) {
        std::fill(difference.begin(), difference.end(), 0.0);
        num::add_combination(row, std::span(matrix).subspan(first * width), difference);
        for (std::size_t l = 0; l < row.size(); ++l) {
            num::add_times(row[l], difference, std::span(result).subspan((first + l) * width, width));
        }
    }
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
