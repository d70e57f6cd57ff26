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
constexpr std::size_t guess_size = 8;
constexpr std::size_t guess_count = 16;

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

/// Roughly u (1 + weight) / (weight turn) of the rule of three points, for `guess_count` equal parts
/// of 0 <= turn <= pi: [i][j] belongs to T_i of the turn in its part and T_j of 2 weight - 1.
using Guess = std::array<std::array<double, guess_size>, guess_size>;
std::span<const Guess> three_point_guesses();

}  // namespace batten::pseudo
