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
constexpr std::size_t far_parts = 12;
constexpr std::size_t bands = 4;

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

/// u (1 + weight) / (weight turn) of the rule of three points as [j][i], which belongs to x^i y^j;
/// x and y go from -1 to 1 with the turn and the weight of the lighter side, u being the heavier
/// side's angle.
using Share = std::array<std::array<double, share_size>, share_size>;

/// A part of the turns between the first kink and the last turn at which u stays below it. The
/// lighter side's angle turn - u then lies before the first kink (band 0), between the first and the
/// second (band 1) and so on, the lighter the further: ties[k] is the weight, by powers of x, at
/// which bands k and k + 1 have the same w. 0 where the turn is below kink k.
struct TurnPart {
    double lo, hi;
    std::array<std::array<double, share_size>, bands - 1> ties;
};
/// From the first kink on without a gap.
std::span<const TurnPart> turn_parts();

/// Where the shares of a band are cut, from 0 at its lower to 1 at its upper tie, in 256ths.
std::span<const int> band_cuts(std::size_t band);

/// For `smooth_parts` equal parts of the turn from 0 to the first kink, each of `weight_parts` of the
/// weight; for each part of the turn, each band's parts of the weight between its ties; then, as a
/// guess, `far_parts` equal parts of the turn up to pi, for all weights.
std::span<const Share> three_point_shares();

}  // namespace batten::pseudo
