#pragma once

#include <cstddef>
#include <vector>

#include "batten/io/grid_file.hpp"

/// Grids whose lines fall, turned round with all that is told line by line.
namespace batten::api {

/// Whether the lines fall throughout.
bool falls(const std::vector<double>& lines);

/// Rows of `width` numbers in reverse order; each row by itself in reverse order.
void reverse_rows(std::vector<double>& numbers, std::size_t width);
void reverse_in_rows(std::vector<double>& numbers, std::size_t width);

/// Places, heights and errors in reverse order.
void turn_x(GridFile& grid);
void turn_y(GridFile& grid);

}  // namespace batten::api
