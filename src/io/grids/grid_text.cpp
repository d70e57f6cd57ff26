#include <algorithm>
#include <cmath>
#include <optional>

#include "batten/base/text.hpp"
#include "io/grids/grid_cells.hpp"
#include "io/grids/readers.hpp"
#include "io/tables/text_rows.hpp"
#include "io/tables/utf8.hpp"

namespace batten::grids {
namespace {

/// Cells of one line; a cell without a number is not finite.
struct TextRow {
    int line = 0;
    std::vector<std::string> cells;
};

std::vector<TextRow> rows_of(std::string_view bytes, const std::string& source) {
    tables::Lines lines(bytes);
    std::vector<TextRow> rows;
    std::vector<std::string_view> cells;
    std::optional<char> separator;
    while (lines.next()) {
        const std::string_view line = lines.text();
        if (trimmed(line).empty() || trimmed(line)[0] == '#') continue;
        if (!separator) separator = tables::separator_of(line);
        // A blank corner is a cell of its own where blanks do not separate.
        if (!tables::split(line, *separator, cells)) {
            throw Error("table.quote", source + " row " + std::to_string(lines.number()),
                        utf8::shown(trimmed(line)),
                        "a quoted cell must end on its line, before the next separator");
        }
        TextRow row{lines.number(), {}};
        for (const std::string_view cell : cells) row.cells.push_back(tables::cell_text(cell));
        rows.push_back(std::move(row));
    }
    if (rows.empty()) {
        throw Error("file.empty", source, "no rows", "the file must hold a grid");
    }
    return rows;
}

void require_row_width(const std::string& source, const TextRow& row, std::size_t width) {
    require_width(row.cells.size(), width, source, row.line);
}

double axis_cell(const std::string& source, const TextRow& row, std::size_t column) {
    return axis_number(row.cells[column], {source, row.line, column});
}

std::optional<double> height_cell(const std::string& source, const TextRow& row, std::size_t column) {
    return height(row.cells[column], {source, row.line, column});
}

GridFile table_form(const std::vector<TextRow>& rows, const std::string& source) {
    const std::size_t width = rows.front().cells.size();
    std::vector<double> x, y;
    for (std::size_t j = 1; j < width; ++j) y.push_back(axis_cell(source, rows.front(), j));
    for (std::size_t i = 1; i < rows.size(); ++i) {
        require_row_width(source, rows[i], width);
        x.push_back(axis_cell(source, rows[i], 0));
    }
    const std::vector<std::size_t> x_order = rising(x, source, "x"), y_order = rising(y, source, "y");
    GridFile file;
    file.x_is_turned = is_turned(x_order);
    file.y_is_turned = is_turned(y_order);
    file.z = Grid(x.size(), y.size());
    for (const std::size_t i : x_order) file.x.push_back(x[i]);
    for (const std::size_t j : y_order) file.y.push_back(y[j]);
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = 0; j < y.size(); ++j) {
            const std::optional<double> value =
                height_cell(source, rows[x_order[i] + 1], y_order[j] + 1);
            if (value) file.z(i, j) = *value;
            else file.z.drop(i, j);
        }
    }
    return file;
}

/// Which column holds what.
struct LongColumns {
    std::size_t x = 0, y = 1, f = 2;
    std::optional<std::size_t> sigma;
};

LongColumns long_columns(const TextRow& first, bool has_names, const std::string& source) {
    LongColumns columns;
    if (!has_names) {
        if (first.cells.size() == 4) columns.sigma = 3;
        return columns;
    }
    const auto find = [&](std::initializer_list<const char*> names) -> std::optional<std::size_t> {
        for (const char* const name : names) {
            const auto at = std::find(first.cells.begin(), first.cells.end(), name);
            if (at != first.cells.end()) return static_cast<std::size_t>(at - first.cells.begin());
        }
        return std::nullopt;
    };
    const auto x = find({"x"}), y = find({"y"}), f = find({"f", "z", "value", "height"});
    if (x && y && f) columns = {*x, *y, *f, find({"sigma", "error"})};
    else if (first.cells.size() < 3) {
        throw Error("grid.not-a-grid", source, std::to_string(first.cells.size()) + " columns",
                    "rows x,y,f[,sigma] or a table with y in its first row are needed");
    } else if (first.cells.size() > 3) {
        columns.sigma = 3;
    }
    return columns;
}

std::size_t line_of(const std::vector<double>& lines, double at) {
    return static_cast<std::size_t>(std::lower_bound(lines.begin(), lines.end(), at) -
                                    lines.begin());
}

std::vector<double> distinct_sorted(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

GridFile long_form(const std::vector<TextRow>& rows, bool has_names, const std::string& source) {
    const LongColumns columns = long_columns(rows.front(), has_names, source);
    const std::size_t width = rows.front().cells.size(), first = has_names ? 1 : 0;
    std::vector<double> x, y;
    for (std::size_t i = first; i < rows.size(); ++i) {
        require_row_width(source, rows[i], width);
        x.push_back(axis_cell(source, rows[i], columns.x));
        y.push_back(axis_cell(source, rows[i], columns.y));
    }
    GridFile file;
    file.x = distinct_sorted(x);
    file.y = distinct_sorted(y);
    const std::size_t nodes = file.x.size() * file.y.size();
    const auto refuse = [&](const std::string& value) {
        return Error("grid.not-a-grid", source, value,
                     "every x must stand with every y once");
    };
    if (file.x.size() > x.size() || nodes != x.size()) {
        throw refuse(std::to_string(x.size()) + " rows, " + std::to_string(file.x.size()) +
                     " different x, " + std::to_string(file.y.size()) + " different y");
    }
    file.z = Grid(file.x.size(), file.y.size());
    std::vector<char> seen(nodes, 0);
    if (columns.sigma) file.sigma.assign(nodes, 1.0);
    for (std::size_t k = 0; k < x.size(); ++k) {
        const TextRow& row = rows[k + first];
        const std::size_t i = line_of(file.x, x[k]), j = line_of(file.y, y[k]);
        if (seen[i * file.y.size() + j]) {
            throw refuse("row " + std::to_string(row.line) + " repeats a node");
        }
        seen[i * file.y.size() + j] = 1;
        const std::optional<double> value = height_cell(source, row, columns.f);
        if (value) file.z(i, j) = *value;
        else file.z.drop(i, j);
        if (columns.sigma) {
            const std::optional<double> sigma = parse_number(row.cells[*columns.sigma]);
            const bool is_good = sigma && *sigma > 0;
            if (value && !is_good) {
                throw Error("fit.sigma", CellPlace{source, row.line, *columns.sigma}.text(),
                            utf8::shown(row.cells[*columns.sigma]), "errors must be above 0");
            }
            if (is_good) file.sigma[i * file.y.size() + j] = *sigma;
        }
    }
    return file;
}

}  // namespace

GridFile read_text(std::string_view bytes, const std::string& source) {
    const std::vector<TextRow> rows = rows_of(bytes, source);
    const std::vector<std::string>& first = rows.front().cells;
    if (!is_long_form(first)) return table_form(rows, source);
    const bool has_names = std::none_of(first.begin(), first.end(), [](const std::string& cell) {
        return parse_number(cell).has_value();
    });
    return long_form(rows, has_names, source);
}

}  // namespace batten::grids
