#pragma once

#include <string>
#include <vector>

#include "batten/base/grid.hpp"
#include "batten/io/files.hpp"
#include "batten/io/grid_file.hpp"

namespace batten {

/// A grid of points in space, and the numbers that name its lines.
struct PointGrid {
    std::vector<double> u, v;  ///< rising
    Grid nodes{0, 0, 3};       ///< u.size() x v.size()
    std::vector<std::string> notes;
};

/// Heights as points (x, y, height); the lines are named by x and y.
PointGrid point_grid_of(const GridFile& heights);

/// A table whose header has u, v, x, y and z: one node a row, in any order, nodes without a row
/// missing; or any grid of heights. Pure.
/// Throws `grid.not-a-grid` where two rows have the same u and v, what parse_table throws and, for
/// bad cells, what points_of throws; for heights what parse_grid throws.
PointGrid parse_point_grid(const Source& source);

}  // namespace batten
