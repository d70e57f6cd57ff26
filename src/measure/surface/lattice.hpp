#pragma once

#include <vector>

#include "batten/base/grid.hpp"
#include "shape/surface/sheet.hpp"

/// The lattice on which lines of equal height are looked for.
namespace batten::contouring {

/// Every piece between knot lines is cut into as many cells, `8` and `64` a side at least.
struct Lattice {
    std::vector<surfaces::SheetLine> lines;  ///< along y
    std::vector<double> rows;                ///< where lines along x are
    std::size_t row_cells = 0;               ///< of one strip

    Grid heights(const surfaces::Sheet& sheet) const { return sheet.heights(lines, rows); }
};

Lattice lattice_of(const surfaces::Sheet& sheet);

/// How far heights between the nodes may be from those on the straight edges: the largest second
/// difference at both ends of an edge, on one side of knot lines. Walls have none.
struct LatticeBends {
    Grid along_x, along_y;  ///< of the edge from node (i, j) to (i + 1, j), or to (i, j + 1)
};

LatticeBends bends_of(const Lattice& lattice, GridView heights);

}  // namespace batten::contouring
