#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"

/// The lines of a grid in one direction, the errors along them, and its heights.
namespace batten::surface_fitting {

/// Throws `fit-surface.axis` unless the lines rise, `points.not-finite`.
void require_rising(std::span<const double> lines, const char* name);

/// The same for all lines of a grid, at least two.
void require_lines(std::span<const double> lines, const char* name);

/// Throws `fit-surface.sizes`, `fit.sigma` unless there are none or `count` errors above 0.
void require_errors(std::span<const double> sigma, std::size_t count, const char* name);

/// Throws `points.not-finite`.
[[noreturn]] void refuse_height(std::size_t row, std::size_t column, double z);

/// Throws `points.not-finite` at the first height that is none; rows of `columns` heights, the
/// first of which the grid has `first` rows before.
void require_finite_heights(std::span<const double> z, std::size_t columns, std::size_t first = 0);

/// The range of heights, one by one.
constexpr Interval no_heights{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
inline void widen(Interval& range, double height) {
    range.lo = std::min(range.lo, height);
    range.hi = std::max(range.hi, height);
}

/// 1 / sigma, or 1.
std::vector<double> weights_of(std::span<const double> sigma, std::size_t count);

}  // namespace batten::surface_fitting
