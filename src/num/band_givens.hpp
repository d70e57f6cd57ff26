#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace batten::num {

/// Least squares with one row of weight for each unknown and rows that touch five neighbours.
///
/// The last `Border` unknowns may be touched by every row: with 4 of them the band closes to a
/// ring. `Sides` right-hand sides. Accuracy: that of Householder QR. Cost: 60 ns a row without
/// border; memory 5 + Border + Sides numbers an unknown.
/// Source: Givens rotations of each row into the triangle, from left to right
/// [LawsonHanson1974, chapter 27].
template <std::size_t Border, std::size_t Sides>
class BandGivens {
public:
    static constexpr std::size_t band = 5;
    static constexpr std::size_t width = band + Border + Sides;
    using Row = std::array<double, width>;  ///< band, border, sides

    /// Forgets everything; `count` unknowns, the border among them, at least band + Border.
    void restart(std::size_t count) {
        columns_ = count - Border;
        rows_.assign(columns_, Row{});
        for (Row& row : border_) row = Row{};
    }
    std::size_t columns() const { return columns_; }

    /// weight x[j] = weight value: before any row that touches x[j].
    void set_weight(std::size_t j, double weight, const std::array<double, Sides>& values) {
        Row& row = j < columns_ ? rows_[j] : border_[j - columns_];
        row[j < columns_ ? 0 : band + (j - columns_)] = weight;
        for (std::size_t k = 0; k < Sides; ++k) row[band + Border + k] = weight * values[k];
    }

    /// Takes in a row whose band part starts at unknown `first`, which must not fall.
    void add(std::size_t first, Row row) {
        const std::size_t reach = std::min(band, columns_ - first);
        for (std::size_t j = 0; j < reach; ++j) {
            Row& pivot = rows_[first + j];
            const double a = pivot[0], b = row[j];
            const double length = std::sqrt(a * a + b * b);
            if (length == 0) continue;
            const double scale = 1 / length, c = a * scale, s = b * scale;
            pivot[0] = length;
            for (std::size_t k = 1; k < band - j; ++k) rotate(pivot[k], row[j + k], c, s);
            for (std::size_t k = band; k < width; ++k) rotate(pivot[k], row[k], c, s);
        }
        if constexpr (Border > 0) add_to_border(row);
    }

    /// The unknowns of one side into `out`, count of them. Unknowns without any weight become 0.
    void solve(std::size_t side, double* out) const {
        const std::size_t value = band + Border + side;
        for (std::size_t j = Border; j-- > 0;) {
            double sum = border_[j][value];
            for (std::size_t k = j + 1; k < Border; ++k) {
                sum -= border_[j][band + k] * out[columns_ + k];
            }
            const double pivot = border_[j][band + j];
            out[columns_ + j] = pivot == 0 ? 0 : sum / pivot;
        }
        for (std::size_t j = columns_; j-- > 0;) {
            const Row& row = rows_[j];
            double sum = row[value];
            const std::size_t reach = std::min(band, columns_ - j);
            for (std::size_t k = 1; k < reach; ++k) sum -= row[k] * out[j + k];
            for (std::size_t k = 0; k < Border; ++k) sum -= row[band + k] * out[columns_ + k];
            out[j] = row[0] == 0 ? 0 : sum / row[0];
        }
    }

private:
    static void rotate(double& p, double& r, double c, double s) {
        const double turned = c * p + s * r;
        r = c * r - s * p;
        p = turned;
    }

    void add_to_border(Row& row) {
        for (std::size_t j = 0; j < Border; ++j) {
            Row& pivot = border_[j];
            const double a = pivot[band + j], b = row[band + j];
            const double length = std::sqrt(a * a + b * b);
            if (length == 0) continue;
            const double c = a / length, s = b / length;
            for (std::size_t k = band + j; k < width; ++k) rotate(pivot[k], row[k], c, s);
        }
    }

    std::size_t columns_ = 0;
    std::vector<Row> rows_;
    std::array<Row, Border == 0 ? 1 : Border> border_{};
};

}  // namespace batten::num
