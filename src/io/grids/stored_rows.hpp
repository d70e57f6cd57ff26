#pragma once

#include <memory>

#include "batten/io/grid_stream.hpp"

namespace batten::grids {

/// The rows of one form of grid, where they lie.
class StoredRows {
public:
    explicit StoredRows(StoredBytes stored) : bytes(std::move(stored)) {}
    virtual ~StoredRows() = default;

    /// Row `row` of the rising ones.
    virtual void read(std::size_t first, std::span<double> z) = 0;

    StoredBytes bytes;
    std::vector<double> x, y;
    bool x_is_turned = false, y_is_turned = false;
};

std::unique_ptr<StoredRows> npy_rows(StoredBytes bytes);
std::unique_ptr<StoredRows> text_rows(StoredBytes bytes);

Error not_streamed(const std::string& source, std::string value);

}  // namespace batten::grids
