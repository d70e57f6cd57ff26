#include "api/fit_table.hpp"

#include <algorithm>
#include <initializer_list>

namespace batten::api {
namespace {

/// The column asked for, else the first of `usual` that is there, else the `place`-th.
int column_of(const Table& table, const std::string& asked, std::initializer_list<const char*> usual,
              int place) {
    if (!asked.empty()) return column_index(table, asked);
    for (const char* const name : usual) {
        if (has_column(table, name)) return column_index(table, name);
    }
    return column_index(table, "#" + std::to_string(place));
}

std::string name_of_column(const Table& table, int column, const char* otherwise) {
    return table.names.empty() ? otherwise : table.names[static_cast<std::size_t>(column)];
}

/// Rows x,y,sigma without names, and no word about columns or errors.
bool is_plain_triple(const Table& table, const FitTableOptions& o) {
    const bool is_asked = !o.x.empty() || !o.y.empty() || o.sigma.is_given() ||
                          !o.fit.sigma_model.empty();
    return table.names.empty() && table.columns() == 3 && !is_asked;
}

}  // namespace

bool has_column(const Table& table, std::string_view name) {
    return std::find(table.names.begin(), table.names.end(), name) != table.names.end();
}

SharedNumbers sigma_of(const PointsInput& input, FitTableOptions& options) {
    const Table& table = input.table;
    const Errors& asked = options.sigma;
    if (asked.width != 1) {
        throw Error("option.value", "sigma", std::to_string(asked.width) + " numbers a row",
                    "must be one error a sample");
    }
    if (asked.all) {
        options.fit.sigma = *asked.all;
    } else if (!asked.each.empty()) {
        return SharedNumbers(asked.each);
    } else if (!asked.column.empty()) {
        return errors_in(input, column_index(table, asked.column));
    } else if (options.fit.sigma_model.empty() && has_column(table, "sigma")) {
        return errors_in(input, column_index(table, "sigma"));
    }
    return {};
}

FitData data_of(const PointsInput& input, FitTableOptions& options) {
    const Table& table = input.table;
    const int x = column_of(table, options.x, {"x"}, 1);
    const int y = column_of(table, options.y, {"y", "f"}, x == 1 && options.y.empty() ? 1 : 2);
    return {column_in(input, x), column_in(input, y),
            is_plain_triple(table, options) ? errors_in(input, 2) : sigma_of(input, options),
            name_of_column(table, x, "x"), name_of_column(table, y, "y")};
}

}  // namespace batten::api
