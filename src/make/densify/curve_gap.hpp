#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "make/densify/cell_curve.hpp"

/// How far the curve of some of the points is from the curve of all.
namespace batten::lagrange {

/// A place on one cell and its distance from the point that was looked for.
struct CellFoot {
    double s = 0;
    double distance = 0;
};

/// The place of a cell nearest to `p`, by Newton's steps from `guess`. It may be a local minimum:
/// then the distance is too large, never too small.
CellFoot foot_on(const CellCurve& curve, std::size_t cell, std::span<const double> p, double guess);

/// At how many of the given cells a kept cell is compared.
enum class Care {
    quick,  ///< about 32 of them, evenly spread
    full,   ///< all
};

/// A cell of the kept points' curve and the given cells [first, last) that it stands for; on a
/// ring they may lie beyond the last given one.
struct Match {
    const CellCurve& kept;
    std::size_t cell, first, last;
};

/// The largest distance, both ways, between the two parts of a match: at 4 places of each given
/// cell, or 1 where there are 16 cells or more, and half way between the places nearest to those.
/// Stops early, with more than `enough`, where it exceeds that.
double largest_gap(const CellCurve& all, const Match& match, Care care, double enough);

}  // namespace batten::lagrange
