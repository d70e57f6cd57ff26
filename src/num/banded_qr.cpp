#include "num/banded_qr.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "num/cubic_band.hpp"
#include "num/householder.hpp"

namespace batten::num {

BandedQr::BandedQr(BandShape shape, std::span<const double> rows,
                   std::span<const double> border_rows) {
    assert(shape.sides == 0);
    restart(shape);
    assert(rows.size() == rows_.size() && border_rows.size() == border_.size());
    std::copy(rows.begin(), rows.end(), rows_.begin());
    std::copy(border_rows.begin(), border_rows.end(), border_.begin());
}

void BandedQr::restart(BandShape shape) {
    assert(shape.width <= shape.columns || shape.border > 0);
    shape_ = shape;
    front_ = 0;
    floors_.clear();
    const std::size_t row = static_cast<std::size_t>(shape.row_width());
    rows_.assign(static_cast<std::size_t>(shape.columns) * row, 0.0);
    work_.assign(static_cast<std::size_t>(shape.width) * row, 0.0);
    border_.assign(static_cast<std::size_t>(shape.border) * border_stride(), 0.0);
    products_.assign(static_cast<std::size_t>(shape.sides * shape.sides), 0.0);
}

void BandedQr::absorb(int first, double* rows, int count) {
    assert(first >= front_);
    emit(first - front_);
    const std::size_t stride = static_cast<std::size_t>(shape_.row_width());
    absorb_above_floors(first, work_.data(), stride, shape_.width, shape_.row_width(), rows, count);
    if (shape_.border > 0) absorb_into_border(rows + shape_.width, count);
    leave_rest(rows, count);
}

void BandedQr::absorb_into_border(double* rows, int count) {
    absorb_above_floors(shape_.columns, border_.data(), border_stride(), shape_.border,
                        shape_.border + shape_.sides, rows, count);
}

void BandedQr::absorb_above_floors(int first, double* triangle, std::size_t stride, int columns,
                                   int width, double* rows, int count) {
    const std::size_t row = static_cast<std::size_t>(shape_.row_width());
    if (floors_.empty()) return num::absorb({triangle, stride, columns, width}, {rows, count, row});
    for (int c = 0; c < columns && first + c < shape_.columns + shape_.border; ++c) {
        double largest = 0;
        for (int i = 0; i < count; ++i) largest = std::max(largest, std::fabs(rows[offset(i) + c]));
        if (!(largest > floors_[static_cast<std::size_t>(first + c)])) continue;
        double* const diagonal = triangle + static_cast<std::size_t>(c) * stride + c;
        num::absorb({diagonal, stride, 1, width - c}, {rows + c, count, row});
    }
}

void BandedQr::leave_rest(const double* rows, int count) {
    const int sides = shape_.sides;
    for (int i = 0; i < count; ++i) {
        const double* const side = rows + offset(i) + shape_.width + shape_.border;
        for (int a = 0; a < sides; ++a) {
            for (int b = 0; b < sides; ++b) {
                products_[static_cast<std::size_t>(a * sides + b)] += side[a] * side[b];
            }
        }
    }
}

void BandedQr::emit(int count) {
    const int width = shape_.width;
    const std::size_t stride = static_cast<std::size_t>(shape_.row_width());
    for (; count > 0; --count) {
        std::copy(work_.begin(), work_.begin() + static_cast<std::ptrdiff_t>(stride),
                  rows_.begin() + static_cast<std::ptrdiff_t>(offset(front_)));
        for (int i = 0; i + 1 < width; ++i) {
            double* const row = work_.data() + offset(i);
            const double* const next = row + stride;
            for (int j = 0; j + 1 < width; ++j) row[j] = next[j + 1];
            row[width - 1] = 0;
            std::copy(next + width, next + stride, row + width);
        }
        double* const last = work_.data() + offset(width - 1);
        std::fill(last, last + stride, 0.0);
        ++front_;
    }
}

void BandedQr::finish() {
    // Rows beyond the last unknown have no band part left: they belong to border and residual.
    emit(shape_.columns - front_);
    if (shape_.border > 0) absorb_into_border(work_.data() + shape_.width, shape_.width);
    leave_rest(work_.data(), shape_.width);
}

void BandedQr::reduce(std::span<const int> firsts, std::span<const double> blocks) {
    if (has_cubic_band() && shape_.sides == 1 && floors_.empty()) {
        products_[0] = reduce_cubic_band(firsts, blocks.data(), shape_.columns, rows_.data());
        front_ = shape_.columns;
        return;
    }
    const std::size_t size = offset(shape_.width);
    std::vector<double> block(size);
    for (std::size_t i = 0; i < firsts.size(); ++i) {
        std::copy_n(blocks.data() + i * size, size, block.data());
        absorb(firsts[i], block.data(), shape_.width);
    }
    finish();
}

double BandedQr::column_sq(int j) const {
    double sum = 0;
    const auto add = [&](double x) { sum += x * x; };
    if (j < shape_.columns) {
        for (int l = 0; l < shape_.width && l <= j; ++l) add(row(j - l)[l]);
        return sum;
    }
    const int b = j - shape_.columns;
    for (int i = 0; i < shape_.columns; ++i) add(row(i)[shape_.width + b]);
    for (int i = 0; i <= b; ++i) add(border_row(i)[b]);
    return sum;
}

double BandedQr::scaled_pivot(int j) const {
    const double pivot =
        j < shape_.columns ? row(j)[0] : border_row(j - shape_.columns)[j - shape_.columns];
    const double column = column_sq(j);
    return column > 0 ? std::fabs(pivot) / std::sqrt(column) : 0;
}

void BandedQr::solve(int side, std::span<double> out) const {
    for (int j = 0; j < shape_.columns; ++j) {
        out[static_cast<std::size_t>(j)] = row(j)[shape_.width + shape_.border + side];
    }
    for (int j = 0; j < shape_.border; ++j) {
        out[static_cast<std::size_t>(shape_.columns + j)] = border_row(j)[shape_.border + side];
    }
    solve_for(out, out);
}

void BandedQr::solve_for(std::span<const double> z, std::span<double> out) const {
    const int columns = shape_.columns;
    if (has_cubic_band()) {
        return solve_cubic_band(rows_.data(), offset(1), columns, z.data(), out.data());
    }
    double* const border = out.data() + columns;
    for (int j = shape_.border; j-- > 0;) {
        const double* const r = border_row(j);
        double value = z[static_cast<std::size_t>(columns + j)];
        for (int l = j + 1; l < shape_.border; ++l) value -= r[l] * border[l];
        border[j] = r[j] == 0 ? 0 : value / r[j];
    }
    for (int j = columns; j-- > 0;) {
        const double* const r = row(j);
        double value = z[static_cast<std::size_t>(j)];
        const int reach = std::min(shape_.width, columns - j);
        for (int l = 1; l < reach; ++l) value -= r[l] * out[static_cast<std::size_t>(j + l)];
        for (int b = 0; b < shape_.border; ++b) value -= r[shape_.width + b] * border[b];
        out[static_cast<std::size_t>(j)] = r[0] == 0 ? 0 : value / r[0];
    }
}

void BandedQr::solve_transposed(std::span<double> a) const {
    const int width = shape_.width, columns = shape_.columns, border = shape_.border;
    double* const beyond = a.data() + columns;
    for (int j = 0; j < columns; ++j) {
        const double* const r = row(j);
        double* const at = a.data() + j;
        const double value = at[0] = r[0] == 0 ? 0 : at[0] / r[0];
        for (int l = 1; l < width && j + l < columns; ++l) at[l] -= r[l] * value;
        for (int b = 0; b < border; ++b) beyond[b] -= r[width + b] * value;
    }
    for (int j = 0; j < border; ++j) {
        const double* const r = border_row(j);
        const double value = beyond[j] = r[j] == 0 ? 0 : beyond[j] / r[j];
        for (int l = j + 1; l < border; ++l) beyond[l] -= r[l] * value;
    }
}

std::vector<double> BandedQr::inverse_band(int reach) const {
    const int width = shape_.width, n = shape_.columns;
    if (has_cubic_band() && (reach == 4 || reach == 5)) {
        std::vector<double> z(static_cast<std::size_t>((n + 3) * reach), 0.0);
        inverse_of_cubic_band(rows_.data(), offset(1), n, reach, z.data());
        z.resize(static_cast<std::size_t>(n * reach));
        return z;
    }
    std::vector<double> z(static_cast<std::size_t>(n * reach), 0.0);
    const auto at = [&](int i, int j) -> double& {
        return z[static_cast<std::size_t>(std::min(i, j) * reach + std::abs(i - j))];
    };
    for (int j = n; j-- > 0;) {
        const double* const r = row(j);
        if (r[0] == 0) continue;
        const int last = std::min(n - 1, j + width - 1);
        for (int i = std::min(n - 1, j + reach - 1); i >= j; --i) {
            double sum = i == j ? 1 / r[0] : 0;
            for (int l = j + 1; l <= last; ++l) sum -= r[l - j] * at(l, i);
            at(j, i) = sum / r[0];
        }
    }
    return z;
}

}  // namespace batten::num
