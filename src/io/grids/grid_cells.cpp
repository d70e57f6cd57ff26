#include "io/grids/grid_cells.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "io/tables/utf8.hpp"

namespace batten::grids {

std::string CellPlace::text() const {
    return source + " row " + std::to_string(line) + ", column " + std::to_string(column + 1);
}

double axis_number(std::string_view cell, const CellPlace& place) {
    const std::optional<double> value = parse_number(cell);
    if (value && std::isfinite(*value)) return *value;
    throw Error("grid.axis", place.text(), cell.empty() ? "empty" : utf8::shown(cell),
                "the places of a grid's lines must be finite numbers");
}

std::optional<double> height(std::string_view cell, const CellPlace& place) {
    if (cell.empty() || cell == "NA" || cell == "-") return std::nullopt;
    const std::optional<double> value = parse_number(cell);
    if (!value || std::isinf(*value)) {
        throw Error("grid.cell", place.text(), utf8::shown(cell),
                    "a height must be a finite number, NaN or empty");
    }
    if (std::isnan(*value)) return std::nullopt;
    return value;
}

void require_width(std::size_t cells, std::size_t width, const std::string& source, int line) {
    if (cells == width) return;
    throw Error("grid.ragged", source + " row " + std::to_string(line),
                std::to_string(cells) + " columns",
                "every row must have " + std::to_string(width) + " columns, like the first");
}

std::vector<std::size_t> rising(const std::vector<double>& given, const std::string& source,
                                const char* axis) {
    std::vector<std::size_t> order(given.size());
    const bool falls = given.size() > 1 && given[1] < given[0];
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = falls ? order.size() - 1 - i : i;
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (given[order[i - 1]] < given[order[i]]) continue;
        const std::size_t at = falls ? order[i - 1] : order[i];
        throw Error("grid.axis", source + ", axis " + axis, format_number(given[at]),
                    "the lines of a grid must rise or fall throughout");
    }
    return order;
}

bool is_long_form(const std::vector<std::string>& first) {
    const auto is_number = [](const std::string& cell) { return parse_number(cell).has_value(); };
    if (!std::any_of(first.begin(), first.end(), is_number)) return true;
    return (first.size() == 3 || first.size() == 4) &&
           std::all_of(first.begin(), first.end(), is_number);
}

}  // namespace batten::grids
