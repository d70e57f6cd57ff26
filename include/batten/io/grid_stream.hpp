#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "batten/io/stored_bytes.hpp"

namespace batten {

namespace grids {
class StoredRows;
}

/// A grid of heights in a file that is read in blocks of rows and never held: `.npy`, or a text
/// table with y in its first row and x in its first column.
///
/// Memory: x and y; of a table three numbers a row; the rows asked for. Of `.npy` in Fortran order
/// 64 MB of rows, so that what is read at a time is long enough.
class GridStream {
public:
    /// Throws what parse_grid throws of the axes, a table's rows or a NumPy header; `grid.streamed`
    /// for a grid in another form. Cost: a table is read once, for the places of its rows.
    explicit GridStream(StoredBytes bytes);
    ~GridStream();
    GridStream(GridStream&&) noexcept;
    GridStream& operator=(GridStream&&) noexcept;

    const std::string& name() const;
    /// Rising: falling ones are turned round, with their heights. Those of `.npy` count from 0.
    const std::vector<double>& x() const;
    const std::vector<double>& y() const;
    /// Whether they fell in the file.
    bool x_is_turned() const;
    bool y_is_turned() const;

    /// The heights of whole rows from row `first` on: z.size() / y().size() of them; NaN where one
    /// is missing. Throws `grid.cell`, `grid.ragged`, `table.quote`, `file.unreadable`.
    void read(std::size_t first, std::span<double> z);

private:
    std::unique_ptr<grids::StoredRows> rows_;
};

}  // namespace batten
