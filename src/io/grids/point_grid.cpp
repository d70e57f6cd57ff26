#include "batten/io/point_grid.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/table.hpp"

namespace batten {
namespace {

constexpr std::array<std::string_view, 5> node_columns = {"u", "v", "x", "y", "z"};

/// The columns of u, v, x, y, z in that order, or none unless all are there.
std::vector<int> node_columns_of(const Table& table) {
    std::vector<int> columns;
    for (const std::string_view name : node_columns) {
        const auto at = std::find(table.names.begin(), table.names.end(), name);
        if (at == table.names.end()) return {};
        columns.push_back(static_cast<int>(at - table.names.begin()));
    }
    return columns;
}

/// Whether the first line of a text names u and v.
bool names_lines(const Source& source) {
    if (grid_format(source) != GridFormat::text) return false;
    const std::string_view bytes = source.bytes;
    std::string line(bytes.substr(0, bytes.find_first_of("\r\n")));
    for (const char separator : {',', ';', '\t', '"'}) {
        std::replace(line.begin(), line.end(), separator, ' ');
    }
    line = ' ' + line + ' ';
    return line.find(" u ") != std::string::npos && line.find(" v ") != std::string::npos;
}

std::vector<double> distinct(const Points& rows, int column) {
    std::vector<double> values;
    for (std::size_t i = 0; i < rows.size(); ++i) values.push_back(rows(i, column));
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::size_t place_of(const std::vector<double>& lines, double value) {
    return static_cast<std::size_t>(std::lower_bound(lines.begin(), lines.end(), value) -
                                    lines.begin());
}

PointGrid nodes_of_rows(const Points& rows, const std::string& source) {
    PointGrid grid{distinct(rows, 0), distinct(rows, 1), Grid(0, 0, 3), {}};
    grid.nodes = Grid(grid.u.size(), grid.v.size(), 3);
    std::vector<char> is_there(grid.u.size() * grid.v.size(), 0);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const std::size_t i = place_of(grid.u, rows(row, 0)), j = place_of(grid.v, rows(row, 1));
        char& there = is_there[i * grid.v.size() + j];
        if (there) {
            throw Error("grid.not-a-grid", source,
                        "u " + format_number(rows(row, 0)) + ", v " + format_number(rows(row, 1)),
                        "every u stands with every v once");
        }
        there = 1;
        for (int k = 0; k < 3; ++k) grid.nodes(i, j, k) = rows(row, 2 + k);
    }
    for (std::size_t i = 0; i < grid.u.size(); ++i) {
        for (std::size_t j = 0; j < grid.v.size(); ++j) {
            if (!is_there[i * grid.v.size() + j]) grid.nodes.drop(i, j);
        }
    }
    return grid;
}

}  // namespace

PointGrid point_grid_of(const GridFile& heights) {
    PointGrid grid{heights.x, heights.y, Grid(heights.x.size(), heights.y.size(), 3),
                   heights.notes};
    for (std::size_t i = 0; i < heights.x.size(); ++i) {
        for (std::size_t j = 0; j < heights.y.size(); ++j) {
            grid.nodes(i, j, 0) = heights.x[i];
            grid.nodes(i, j, 1) = heights.y[j];
            grid.nodes(i, j, 2) = heights.z(i, j);
            if (!heights.z.has(i, j)) grid.nodes.drop(i, j);
        }
    }
    return grid;
}

PointGrid parse_point_grid(const Source& source) {
    if (!names_lines(source)) return point_grid_of(parse_grid(source));
    const Table table = parse_table(source, TableFormat::text);
    const std::vector<int> columns = node_columns_of(table);
    if (columns.empty()) return point_grid_of(parse_grid(source));
    PointGrid grid = nodes_of_rows(points_of(table, columns), source.name);
    grid.notes = table.notes;
    return grid;
}

}  // namespace batten
