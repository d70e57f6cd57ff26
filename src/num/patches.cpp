#include "num/patches.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "num/patch_kernel.hpp"

namespace batten::patches {
namespace {

constexpr const char* alphabet = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz+-";

std::array<std::uint8_t, 128> values_of_digits() {
    std::array<std::uint8_t, 128> values{};
    for (std::uint8_t i = 0; i < 64; ++i) values[static_cast<std::size_t>(alphabet[i])] = i;
    return values;
}

}  // namespace

char digit(unsigned value) { return alphabet[value]; }

/// Whole numbers from text.
class Table::Reader {
public:
    explicit Reader(std::span<const char* const> text)
        : text_(text), at_(text.front()), values_(values_of_digits()) {}

    std::uint64_t number() {
        std::uint64_t sum = 0;
        for (int shift = 0;; shift += 5) {
            if (*at_ == 0) at_ = text_[++line_];
            const std::uint64_t digit = values_[static_cast<std::size_t>(*at_++)];
            sum |= (digit & 31) << shift;
            if (digit < 32) return sum;
        }
    }
    double signed_number() {
        const std::uint64_t n = number();
        const double size = static_cast<double>(n >> 1);
        return n & 1 ? -size : size;
    }
    int small_number() { return static_cast<int>(number()); }

private:
    std::span<const char* const> text_;
    std::size_t line_ = 0;
    const char* at_;
    std::array<std::uint8_t, 128> values_;
};

/// A rectangle of the smallest cells: where it begins, and how often it was halved.
struct Table::Cell {
    std::size_t x = 0, y = 0;
    int x_level = 0, y_level = 0;
};

Table::Table(std::span<const char* const> text, Box box) : box_(box) {
    Reader reader(text);
    shape_.width = reader.small_number();
    shape_.height = reader.small_number();
    shape_.outputs = reader.small_number();
    x_levels_ = reader.small_number();
    y_levels_ = reader.small_number();
    x_cells_ = std::ldexp(1.0, x_levels_) / box.x.length();
    y_cells_ = std::ldexp(1.0, y_levels_) / box.y.length();
    patch_of_cell_.resize(std::size_t{1} << (x_levels_ + y_levels_));
    read(reader, {});
}

void Table::read(Reader& reader, const Cell& cell) {
    const int code = reader.small_number();
    if (code > 1) return read_patch(reader, cell, code - 2);
    Cell lower = cell;
    ++(code == 0 ? lower.x_level : lower.y_level);
    Cell upper = lower;
    if (code == 0) {
        upper.x += std::size_t{1} << (x_levels_ - lower.x_level);
    } else {
        upper.y += std::size_t{1} << (y_levels_ - lower.y_level);
    }
    read(reader, lower);
    read(reader, upper);
}

void Table::read_patch(Reader& reader, const Cell& cell, int functions) {
    const std::size_t columns = std::size_t{1} << (x_levels_ - cell.x_level);
    const std::size_t rows = std::size_t{1} << (y_levels_ - cell.y_level);
    const double half_x = 0.5 * static_cast<double>(columns), half_y = 0.5 * static_cast<double>(rows);
    assert(patches_.size() < 0x10000);
    for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t first = ((cell.x + i) << y_levels_) + cell.y;
        std::fill_n(patch_of_cell_.begin() + static_cast<std::ptrdiff_t>(first), rows,
                    static_cast<std::uint16_t>(patches_.size()));
    }
    patches_.push_back({box_.x.lo + (static_cast<double>(cell.x) + half_x) / x_cells_,
                        box_.y.lo + (static_cast<double>(cell.y) + half_y) / y_cells_,
                        x_cells_ / half_x, y_cells_ / half_y, coefficients_.size(), functions});
    const std::size_t outputs = static_cast<std::size_t>(shape_.outputs);
    for (int f = 0; f < functions; ++f) {
        Outputs units{};
        for (std::size_t k = 0; k < outputs; ++k) {
            units[k] = std::ldexp(1.0, static_cast<int>(reader.signed_number()));
        }
        for (std::size_t i = 0; i < shape_.numbers(); ++i) {
            coefficients_.push_back(units[i % outputs] * reader.signed_number());
        }
    }
}

Place Table::find(double x, double y) const {
    const auto cell = [](double at, int levels) {
        const std::ptrdiff_t last = (std::ptrdiff_t{1} << levels) - 1;
        return static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(at), 0, last));
    };
    const std::size_t column = cell((x - box_.x.lo) * x_cells_, x_levels_);
    const std::size_t row = cell((y - box_.y.lo) * y_cells_, y_levels_);
    const Patch& patch = patches_[patch_of_cell_[(column << y_levels_) + row]];
    return {(x - patch.x) * patch.x_scale, (y - patch.y) * patch.y_scale,
            coefficients_.data() + patch.first, patch.functions};
}

Outputs Table::value(const Place& place, int i) const {
    return polynomial(
        shape_, place.coefficients + static_cast<std::size_t>(i) * shape_.numbers(), place.u,
        place.v);
}

}  // namespace batten::patches
