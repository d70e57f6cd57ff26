#pragma once

#include <cstddef>
#include <vector>

#include "make/densify/cell_curve.hpp"

namespace batten::lagrange {

/// In how many equal steps each cell is divided: one number for each, or one for all.
struct Division {
    std::vector<std::size_t> steps;

    std::size_t of(std::size_t cell) const { return steps.size() == 1 ? steps[0] : steps[cell]; }
};

/// The largest distance of the curve from the chords of its division, within a millionth of it:
/// chords whose bound max |f''| / 8 does not promise more than was found are left out.
double largest_chord_error(const CellCurve& curve, const Division& division);

/// The angle between the tangents on both sides of each joint where two cells meet, from the end
/// of cell 0 on (closed: from the start of cell 0 on); signed in the plane. 0 where a tangent
/// vanishes.
std::vector<double> tangent_jumps(const CellCurve& curve);

}  // namespace batten::lagrange
