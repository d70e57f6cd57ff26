#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "make/pseudo/tables/charts.hpp"

/// What tools/tables made from the minimiser.
namespace batten::pseudo {

/// The least segments of a chart, for patches::Table.
std::span<const char* const> segment_text(Chart chart);

constexpr std::size_t end_size = 12;
constexpr std::size_t share_size = 8;
constexpr std::size_t smooth_parts = 12;
constexpr std::size_t weight_parts = 8;
constexpr std::size_t rough_parts = 16;

/// J(theta) / theta^2 and theta1(theta) / theta from `lo` to `hi`, as powers of
/// x = (theta - middle) / half the width.
struct EndPiece {
    double lo, hi;
    std::array<double, end_size> energy, ratio;
};

/// From 0 to pi without a gap.
std::span<const EndPiece> end_pieces();

/// Where the least free end passes to another minimum: theta1 and the slope of J jump.
std::span<const double> end_kinks();

/// u (1 + weight) / (weight turn) of the rule of three points, over the turn and the weight of the
/// lighter side: for `smooth_parts` equal parts of the turn from 0 to the first kink, each of
/// `weight_parts` of the weight; then, as a guess, `rough_parts` from there to pi for all weights.
/// [j][i] belongs to x^i y^j; x and y go from -1 to 1 with the turn and the weight.
using Share = std::array<std::array<double, share_size>, share_size>;
std::span<const Share> three_point_shares();

}  // namespace batten::pseudo
