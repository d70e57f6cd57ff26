#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

/// Systems whose matrix is a narrow band.
///
/// The matrix is never stored: `row(i)` says what stands in row i, and every right-hand side is a
/// column of n numbers that the solution replaces. No pivoting: each row must be dominated by its
/// diagonal, or become so by the elimination of its neighbours (as the ends of a spline do).
namespace batten::num {

/// Row i of a tridiagonal matrix: lower x[i-1] + diagonal x[i] + upper x[i+1].
/// In the first row `lower`, in the last one `upper` belong to the other end of x where the matrix
/// is cyclic, and must be 0 where it is not.
struct TridiagonalRow {
    double lower = 0;
    double diagonal = 1;
    double upper = 0;
};

namespace banded {

/// One end of an elimination: what the last row done says about the next one.
template <std::size_t Columns>
struct Front {
    double share = 0;  ///< x[last] = value - share x[next]
    std::array<double, Columns> values{};
};

/// Eliminates x[i - 1] (or x[i + 1], with the row seen from the other end).
template <std::size_t Columns>
void eliminate(Front<Columns>& front, TridiagonalRow r, std::size_t i,
               const std::array<double*, Columns>& x) {
    const double pivot = r.diagonal - r.lower * front.share;
    const double scale = 1 / pivot;
    front.share = r.upper / pivot;
    for (std::size_t k = 0; k < Columns; ++k) {
        x[k][i] = front.values[k] = (x[k][i] - r.lower * front.values[k]) * scale;
    }
}

template <std::size_t Columns>
void substitute(std::array<double, Columns>& last, double share, std::size_t i,
                const std::array<double*, Columns>& x) {
    for (std::size_t k = 0; k < Columns; ++k) x[k][i] = last[k] = x[k][i] - share * last[k];
}

/// Elimination from both ends towards the middle row: two short chains instead of a long one, and
/// the same rounding for a system of odd size and its reversal.
template <std::size_t Columns, class Row>
void solve_block(std::size_t n, Row& row, const std::array<double*, Columns>& x,
                 std::span<double> shares) {
    const std::size_t middle = n / 2;
    const std::size_t pairs = n - 1 - middle;
    const bool is_even = pairs < middle;
    Front<Columns> down, up;
    for (std::size_t i = 0; i < pairs; ++i) {
        const std::size_t j = n - 1 - i;
        const TridiagonalRow r = row(j);
        eliminate(down, row(i), i, x);
        eliminate(up, {r.upper, r.diagonal, r.lower}, j, x);
        shares[i] = down.share;
        shares[j] = up.share;
    }
    if (is_even) {
        eliminate(down, row(pairs), pairs, x);
        shares[pairs] = down.share;
    }
    const TridiagonalRow r = row(middle);
    const double pivot = r.diagonal - (r.lower * down.share + r.upper * up.share);
    std::array<double, Columns> left, right;
    for (std::size_t k = 0; k < Columns; ++k) {
        const double known = r.lower * down.values[k] + r.upper * up.values[k];
        x[k][middle] = left[k] = right[k] = (x[k][middle] - known) / pivot;
    }
    if (is_even) substitute(left, shares[pairs], pairs, x);
    for (std::size_t i = pairs; i-- > 0;) {
        const std::size_t j = n - 1 - i;
        substitute(left, shares[i], i, x);
        substitute(right, shares[j], j, x);
    }
}

}  // namespace banded

/// Solves a tridiagonal system for all `columns` at once, in place; `work` holds n numbers.
///
/// Accuracy: backward stable for diagonally dominant rows. Laws: rows x 2^k or columns x 2^k give
/// solutions x 2^-k or 2^k exactly. Cost: two divisions a row and four columns, and 5 operations a
/// number; no allocation.
/// Source: Gaussian elimination from both ends [LINPACK1979, DPTSL].
template <class Row>
void solve_tridiagonal(std::size_t n, Row&& row, std::span<double* const> columns,
                       std::span<double> work) {
    while (columns.size() >= 4) {
        banded::solve_block<4>(n, row, {columns[0], columns[1], columns[2], columns[3]}, work);
        columns = columns.subspan(4);
    }
    if (columns.size() == 3) {
        banded::solve_block<3>(n, row, {columns[0], columns[1], columns[2]}, work);
    } else if (columns.size() == 2) {
        banded::solve_block<2>(n, row, {columns[0], columns[1]}, work);
    } else if (columns.size() == 1) {
        banded::solve_block<1>(n, row, {columns[0]}, work);
    }
}

/// The same for a cyclic matrix, n >= 3: the first row reaches x[n-1], the last one x[0].
///
/// Accuracy: as above, where the matrix without its first row and column is dominated too.
/// Cost: as above for one column more, and one allocation.
/// Source: x[0] is kept as a parameter, and found from the first row at last.
template <class Row>
void solve_cyclic(std::size_t n, Row&& row, std::span<double* const> columns,
                  std::span<double> work) {
    const std::size_t inner = n - 1;
    std::vector<double> response(inner, 0.0);
    response.front() = row(1).lower;
    response.back() += row(n - 1).upper;
    const auto inner_row = [&](std::size_t i) {
        TridiagonalRow r = row(i + 1);
        if (i == 0) r.lower = 0;
        if (i + 1 == inner) r.upper = 0;
        return r;
    };
    std::vector<double*> inner_columns{response.data()};
    for (double* const x : columns) inner_columns.push_back(x + 1);
    solve_tridiagonal(inner, inner_row, inner_columns, work);
    const TridiagonalRow first = row(0);
    const double pivot =
        first.diagonal - (first.lower * response.back() + first.upper * response.front());
    for (double* const x : columns) {
        x[0] = (x[0] - (first.lower * x[n - 1] + first.upper * x[1])) / pivot;
        for (std::size_t i = 1; i < n; ++i) x[i] -= x[0] * response[i - 1];
    }
}

}  // namespace batten::num
