#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/io/grid_file.hpp"

namespace batten::grids {

GridFile read_text(std::string_view bytes, const std::string& source);
GridFile read_pgm(std::string_view bytes, const std::string& source);
GridFile read_png(std::string_view bytes, const std::string& source);

/// A grey picture, row after row from the top, as a grid.
GridFile picture_grid(std::vector<double> grey, std::size_t width, const std::string& source);

inline Error not_a_picture(const std::string& source, std::string value, std::string rule) {
    return {"picture.format", source, std::move(value), std::move(rule)};
}

/// The most pixels that are read.
constexpr std::size_t most_pixels = std::size_t{1} << 27;

}  // namespace batten::grids
