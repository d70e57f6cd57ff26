#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace batten::num {

/// What a least-squares problem looks like: `columns` unknowns in a band, each row touching
/// `width` neighbours, then `border` unknowns that any row may touch, and `sides` right-hand sides.
struct BandShape {
    int width = 1;
    int columns = 1;
    int border = 0;
    int sides = 1;

    int row_width() const { return width + border + sides; }
};

/// Banded least squares by orthogonal reduction, rows taken in from left to right.
///
/// Cost: about 4 rows x width x (width + border + sides) operations; memory columns x row_width.
/// Accuracy: that of Householder QR, columns of any scale.
/// Source: sequential reduction of banded problems [LawsonHanson1974, chapter 27].
class BandedQr {
public:
    BandedQr() = default;
    explicit BandedQr(BandShape shape) { restart(shape); }

    /// A triangle that was kept, without sides: columns rows of width + border numbers each, then
    /// border rows of border numbers.
    BandedQr(BandShape shape, std::span<const double> rows, std::span<const double> border_rows);

    /// Forgets everything; keeps the memory.
    void restart(BandShape shape);
    /// Until the next restart: what rows hold of unknown j (band, then border), once the unknowns
    /// before it are eliminated, counts as nothing where no entry is above floors[j]. So inf leaves
    /// it without a pivot: for unknowns that depend on those before them.
    void set_floors(std::vector<double> floors) { floors_ = std::move(floors); }
    /// Takes in `rows` rows of row_width() numbers each, whose band part stands in columns
    /// first ... first + width - 1. `first` must not fall. The rows are destroyed.
    void absorb(int first, double* rows, int count);
    /// To be called once, after the last row.
    void finish();
    /// All rows at once, instead of absorb() and finish(): blocks of `width` rows, block i in columns
    /// firsts[i] ... The rows are kept.
    void reduce(std::span<const int> firsts, std::span<const double> blocks);

    const BandShape& shape() const { return shape_; }
    /// Row j of the triangle: width band numbers (the diagonal first), border, sides.
    const double* row(int j) const { return rows_.data() + offset(j); }
    double* row(int j) { return rows_.data() + offset(j); }
    /// Row j of the border's own triangle: border numbers, then sides.
    const double* border_row(int j) const {
        return border_.data() + static_cast<std::size_t>(j) * border_stride();
    }

    /// What no choice of unknowns can reach: the sides' inner products, sides x sides.
    std::span<const double> residual_products() const { return products_; }

    /// |column|^2 of unknown j (band, then border).
    double column_sq(int j) const;
    /// |diagonal| / |column| of unknown j (band, then border): near 0 where the rank is deficient.
    double scaled_pivot(int j) const;

    /// The unknowns (band, then border) for one side, into `out`. Unknowns with a zero pivot
    /// become 0.
    void solve(int side, std::span<double> out) const;
    /// The same for a right-hand side of the triangle itself: R out = z.
    void solve_for(std::span<const double> z, std::span<double> out) const;
    /// R^-T a, in place.
    void solve_transposed(std::span<double> a) const;

    /// The entries of (R^T R)^-1 up to `reach` columns right of the diagonal and itself, row after
    /// row; `reach` at least the band's width. No border. Rows with a zero pivot are 0.
    ///
    /// Cost: O(columns width reach). Source: R Z = R^-T, whose upper part is known
    /// [HutchinsonDeHoog1985].
    std::vector<double> inverse_band(int reach) const;

private:
    std::size_t offset(int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(shape_.row_width());
    }
    std::size_t border_stride() const {
        return static_cast<std::size_t>(shape_.border + shape_.sides);
    }
    void emit(int count);
    void absorb_into_border(double* rows, int count);
    /// `rows` into the triangle of unknowns first ..., column by column, floors observed.
    void absorb_above_floors(int first, double* triangle, std::size_t stride, int columns, int width,
                             double* rows, int count);
    void leave_rest(const double* rows, int count);
    bool has_cubic_band() const { return shape_.width == 4 && shape_.border == 0; }

    BandShape shape_;
    int front_ = 0;
    std::vector<double> rows_, work_, border_, products_, floors_;
};

}  // namespace batten::num
