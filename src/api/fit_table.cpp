#include "api/fit_table.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>

namespace batten::api {
namespace {

/// The first column of `usual` that is there and not taken.
std::optional<int> usual_column(const Table& table, std::initializer_list<const char*> usual,
                                int taken) {
    for (const char* const name : usual) {
        if (has_column(table, name) && column_index(table, name) != taken) {
            return column_index(table, name);
        }
    }
    return std::nullopt;
}

/// The first column that is not taken. Throws `table.unknown-column` where all are.
int free_column(const Table& table, std::initializer_list<int> taken) {
    int column = 0;
    while (std::find(taken.begin(), taken.end(), column) != taken.end()) ++column;
    return column_index(table, "#" + std::to_string(column + 1));
}

constexpr int no_column = -1;

/// The column of the errors, where one is asked for or has their name.
int sigma_column(const Table& table, const Errors& sigma) {
    if (!sigma.column.empty()) return column_index(table, sigma.column);
    return has_column(table, "sigma") ? column_index(table, "sigma") : no_column;
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

std::array<int, 2> function_columns(const Table& table, const FitTableOptions& options) {
    const int sigma = sigma_column(table, options.sigma);
    const int asked_x = options.x.empty() ? no_column : column_index(table, options.x);
    const int asked_y = options.y.empty() ? no_column : column_index(table, options.y);
    const auto found = [&](std::initializer_list<const char*> usual, int taken) {
        const std::optional<int> named = usual_column(table, usual, taken);
        return named ? *named : free_column(table, {sigma, taken});
    };
    const int x = asked_x != no_column ? asked_x : found({"x"}, asked_y);
    return {x, asked_y != no_column ? asked_y : found({"y", "f"}, x)};
}

FitData data_of(const PointsInput& input, FitTableOptions& options) {
    const Table& table = input.table;
    const auto [x, y] = function_columns(table, options);
    return {column_in(input, x), column_in(input, y),
            is_plain_triple(table, options) ? errors_in(input, 2) : sigma_of(input, options),
            name_of_column(table, x, "x"), name_of_column(table, y, "y")};
}

std::optional<std::string> note_of_unused(const PointsInput& input,
                                          const FitTableOptions& options) {
    const Table& table = input.table;
    const bool has_errors = options.sigma.is_given() || !options.fit.sigma_model.empty() ||
                            sigma_column(table, options.sigma) != no_column;
    if (table.names.empty() || table.columns() != 3 || has_errors) return std::nullopt;
    const auto [x, y] = function_columns(table, options);
    if (x == y) return std::nullopt;
    const int left = 3 - x - y;
    const std::string& name = table.names[static_cast<std::size_t>(left)];
    return "column " + name + " is not used; if it holds the errors, --sigma " + name + " takes it";
}

}  // namespace batten::api
