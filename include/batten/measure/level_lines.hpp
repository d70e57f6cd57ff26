#pragma once

#include <span>
#include <vector>

#include "batten/base/grid.hpp"
#include "batten/base/points.hpp"

namespace batten {

/// Lines of equal height of heights on a grid, linear along its lines: as many polylines as there
/// are pieces, closed ones return to their first point. Lines end where nodes are missing.
///
/// Where a cell is a saddle, the mean of its corners tells how lines go on. For a surface known
/// between nodes, `contours` is exact.
/// Cost: linear in the nodes. Throws `grid.places` unless x and y have as many numbers as z has
/// rows and columns.
/// Source: marching squares [LorensenCline1987].
std::vector<Points> level_lines(std::span<const double> x, std::span<const double> y, GridView z,
                                double level);

}  // namespace batten
