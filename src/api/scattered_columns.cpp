#include "api/scattered_columns.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "batten/base/error.hpp"

namespace batten::api {
namespace {

std::optional<int> column_called(const Table& table, std::initializer_list<const char*> names) {
    for (const char* const name : names) {
        const auto at = std::find(table.names.begin(), table.names.end(), name);
        if (at != table.names.end()) return column_index(table, name);
    }
    return std::nullopt;
}

std::vector<int> picked(const Table& table, std::string_view picks) {
    std::vector<int> columns;
    for (std::size_t start = 0; start <= picks.size();) {
        const std::size_t end = std::min(picks.find(',', start), picks.size());
        columns.push_back(column_index(table, picks.substr(start, end - start)));
        start = end + 1;
    }
    if (columns.size() == 3 || columns.size() == 4) return columns;
    throw Error("option.value", "columns", std::to_string(columns.size()),
                "three are picked, x, y and z, or a fourth with the errors");
}

/// Names of columns that number the rows.
bool numbers_rows(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array<std::string_view, 12> usual{"id",  "index", "idx", "no",    "no.", "nr",
                                                     "num", "number", "row", "point", "fid", "#"};
    return std::find(usual.begin(), usual.end(), name) != usual.end();
}

std::string all_labels(const Table& table) {
    std::string text;
    for (int k = 0; k < table.columns(); ++k) text += (k > 0 ? ", " : "") + table.label(k);
    return text;
}

}  // namespace

ScatteredColumns scattered_columns(const Table& table, const std::string& picks) {
    const std::optional<int> sigma = column_called(table, {"sigma", "error"});
    if (!picks.empty()) {
        const std::vector<int> c = picked(table, picks);
        return {c[0], c[1], c[2], c.size() == 4 ? std::optional(c[3]) : sigma};
    }
    const std::optional<int> x = column_called(table, {"x"}), y = column_called(table, {"y"});
    const std::optional<int> z = column_called(table, {"z", "f", "value", "height"});
    if (x && y && z) return {*x, *y, *z, sigma};
    const bool has_names = !table.names.empty();
    const bool is_plain = table.columns() == 3 || (table.columns() == 4 && !has_names);
    const bool has_errors_last = table.columns() == 4 && sigma == 3;
    const bool is_numbered = has_names && numbers_rows(table.names.front());
    if (is_numbered || !(is_plain || has_errors_last)) {
        throw Error("table.columns", table.source, all_labels(table),
                    "which columns are x, y and z must be clear: three, or named so; --columns "
                    "A,B,C picks them");
    }
    return {0, 1, 2, table.columns() == 4 ? std::optional(3) : std::nullopt};
}

}  // namespace batten::api
