#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "batten/io/stored_bytes.hpp"

namespace batten::tables {

/// What the header of a NumPy file declares [NumPyFormat].
struct NpyHeader {
    char kind = 'f';  ///< f float, i integer, u integer without sign
    std::size_t width = 8;
    bool is_big_endian = false;
    bool is_fortran = false;
    std::vector<std::size_t> shape;
    std::size_t end = 0;  ///< where the numbers start in the file
};

/// The header at the start of these bytes. Throws `npy.header`, `npy.type`.
NpyHeader read_npy_header(std::string_view bytes, const std::string& source);

/// Throws `npy.shape` unless there are two dimensions that hold something, `npy.truncated` unless
/// `bytes` behind the header hold all.
void require_npy_grid(const NpyHeader& header, std::uint64_t bytes, const std::string& source);

/// The header of an array that stays where it is. Throws what both throw.
NpyHeader stored_npy_grid(StoredBytes& bytes);

/// Numbers that stand one behind the other.
void npy_numbers(const NpyHeader& header, const char* bytes, std::span<double> out);

/// A two-dimensional NumPy array, row after row, not finite numbers as they are.
struct NpyGrid {
    std::size_t rows = 0, columns = 0;
    std::vector<double> values;
};

/// Throws `npy.header`, `npy.type`, `npy.shape`, `npy.truncated`.
NpyGrid read_npy_grid(std::string_view bytes, const std::string& source);

}  // namespace batten::tables
