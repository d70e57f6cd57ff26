#pragma once

#include <cstddef>
#include <span>

/// Banded least squares with four neighbours a row, one side and no border: what cubic splines are
/// made of. The loops of BandedQr with sizes known beforehand.
namespace batten::num {

/// Reduces blocks of 4 rows of 4 + 1 numbers, block i standing in columns firsts[i] ... + 3, to
/// `columns` rows of 4 + 1 numbers. Returns the square of what no unknowns reach.
///
/// Accuracy: that of Householder QR, columns of any scale. Cost: 4 reflections a block, which
/// overlap with those of the next one.
double reduce_cubic_band(std::span<const int> firsts, const double* blocks, int columns,
                         double* rows);

/// R out = z for `columns` rows of 4 numbers, `stride` apart; unknowns with a zero pivot become 0.
/// `z` and `out` may be the same.
void solve_cubic_band(const double* rows, std::size_t stride, int columns, const double* z,
                      double* out);

/// (R^T R)^-1 up to `reach` columns, 4 or 5, as BandedQr::inverse_band gives it; `out` holds
/// (columns + 3) x reach numbers, zero beforehand.
void inverse_of_cubic_band(const double* rows, std::size_t stride, int columns, int reach,
                           double* out);

}  // namespace batten::num
