#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What the cells of a grid in text mean.
namespace batten::grids {

struct CellPlace {
    const std::string& source;
    int line;
    std::size_t column;  ///< from 0

    std::string text() const;
};

/// A finite number; an axis has no missing cells. Throws `grid.axis`.
double axis_number(std::string_view cell, const CellPlace& place);

/// A height, or nothing where it is missing. Throws `grid.cell`.
std::optional<double> height(std::string_view cell, const CellPlace& place);

/// Throws `grid.ragged` unless a row has as many cells as the first.
void require_width(std::size_t cells, std::size_t width, const std::string& source, int line);

/// The places of the lines in rising order: order[k] is the given index of line k. Throws
/// `grid.axis`.
std::vector<std::size_t> rising(const std::vector<double>& given, const std::string& source,
                                const char* axis);

/// Whether that order is the other way round.
inline bool is_turned(const std::vector<std::size_t>& order) {
    return !order.empty() && order.front() != 0;
}

/// Whether the first row shows rows x, y, f[, sigma] rather than a table.
bool is_long_form(const std::vector<std::string>& first);

}  // namespace batten::grids
