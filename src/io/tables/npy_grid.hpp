#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace batten::tables {

/// A two-dimensional NumPy array, row after row, not finite numbers as they are.
struct NpyGrid {
    std::size_t rows = 0, columns = 0;
    std::vector<double> values;
};

/// Throws `npy.header`, `npy.type`, `npy.shape`, `npy.truncated`.
NpyGrid read_npy_grid(std::string_view bytes, const std::string& source);

}  // namespace batten::tables
