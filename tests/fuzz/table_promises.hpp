#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "batten/io/table.hpp"
#include "batten/io/write_points.hpp"
#include "promises.hpp"

namespace batten::fuzz {

/// Reads the bytes as a table; what it gives is whole, finite but for infinite errors of a column
/// that says so, and reads back from what it writes.
inline void check_table(const std::uint8_t* data, std::size_t size, TableFormat format) {
    const Source source{"input", std::string(reinterpret_cast<const char*>(data), size)};
    try {
        table_format(source);
        const Table table = parse_table(source, format);
        const std::size_t rows = table.cells.size();
        require(rows > 0 && table.columns() > 0);
        require(table.line_of_row.size() == rows);
        require(table.bad.size() == static_cast<std::size_t>(table.columns()));
        require(table.names.empty() || table.names.size() == table.bad.size());
        bool is_finite = true;
        for (std::size_t i = 0; i < rows; ++i) {
            for (std::size_t k = 0; k < table.bad.size(); ++k) {
                const double x = table.cells[i][k];
                require(std::isfinite(x) || (x > 0 && table.bad[k]));
                is_finite = is_finite && std::isfinite(x);
            }
        }
        if (is_finite) {
            const Source copy{"copy.csv", csv_points(table.cells, {})};
            require(parse_table(copy).cells == table.cells);
        }
        points_of(table, coordinate_columns(table));
    } catch (const Error& error) {
        check_error(error);
    }
}

}  // namespace batten::fuzz
