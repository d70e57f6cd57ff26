#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "measure/bezier/stretch.hpp"
#include "num/chebyshev.hpp"

namespace batten::arc {

constexpr std::size_t most_terms = 24;

/// How fast what is added up grows: writes the rate at each w, never negative.
using Rate = std::function<void(std::span<const double> w, std::span<double> out)>;

/// The speed |dr/dw| of a stretch over w in [0, 1].
Rate speed_of(const bezier::Stretch& stretch, const std::vector<chebyshev::Basis>& bases);

/// Two Chebyshev sums on an interval of w, both in relative terms: with sigma and x running from
/// -1 to 1 over the length and over w,
///     s = s_lo + length sum forward_k T_k(x),   w = w_lo + (w_hi - w_lo) sum inverse_k T_k(sigma).
struct Cell {
    double length = 0;  ///< the integral of the rate
    double error = 0;   ///< of the length, as the last terms tell it
    std::size_t forward_terms = 0, inverse_terms = 0;
    double forward[most_terms], inverse[most_terms];
};

/// How much may be wrong in a cell, in units of its length.
struct Allowed {
    double length = 0;  ///< its length
    double place = 0;   ///< the length at the w given for a length
};

/// The cell over w in `part`, or nothing where 24 terms do not reach what is allowed: then halve.
/// A part shorter than is allowed to be wrong is taken to be passed at one rate: so the halving
/// ends where the rate falls to zero, without a look at the size of the part itself.
///
/// Accuracy: the last three terms of the rate, integrated, stay below allowed.length; the inverse
/// is looked at between its nodes and at both ends and stays below allowed.place there.
std::optional<Cell> cell_over(const Rate& rate, Interval part, const Allowed& allowed);

/// The cell passed at one rate, its length by 8 nodes, whatever the error.
Cell even_cell_over(const Rate& rate, Interval part);

}  // namespace batten::arc
