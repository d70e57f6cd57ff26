#include "batten/api/argument.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/fit_table.hpp"
#include "api/spline_panel.hpp"
#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/io/table.hpp"
#include "batten/io/write_points.hpp"

namespace batten {
namespace {

[[noreturn]] void refuse_value(const Field& field, const char* what) {
    throw Error("option.value", field.name, what, "takes " + field.takes);
}

std::string typed_text(const Field& field, const Value& value) {
    if (const bool* truth = value.truth()) {
        return *truth && !field.bare.empty() ? field.bare : *truth ? "true" : "false";
    }
    if (const long long* whole = value.integer()) return std::to_string(*whole);
    if (const double* real = value.real()) return format_number(*real);
    if (const std::string* text = value.text()) return *text;
    refuse_value(field, value.is_null() ? "null" : "a list or map inside a list");
}

bool is_all_numbers(const ValueList& list) {
    return std::all_of(list.begin(), list.end(), [](const Value& x) { return x.is_number(); });
}

/// Rows of equally many numbers; of errors `null` where nothing was measured.
std::optional<Points> rows_in(const Field& field, const ValueList& list) {
    const ValueList* first = list.empty() ? nullptr : list.front().list();
    if (!first || first->empty()) return std::nullopt;
    Points rows(0, static_cast<int>(first->size()));
    std::vector<double> row;
    for (const Value& each : list) {
        const ValueList* numbers = each.list();
        if (!numbers || numbers->size() != first->size()) return std::nullopt;
        row.clear();
        for (const Value& x : *numbers) {
            const bool is_gap = x.is_null() && field.kind == FieldKind::errors;
            if (!is_gap && !x.is_number()) return std::nullopt;
            row.push_back(is_gap ? std::numeric_limits<double>::quiet_NaN() : x.number());
        }
        rows.push_back(row);
    }
    return rows;
}

Argument list_argument(const Field& field, const ValueList& list) {
    const bool takes_numbers = field.takes_file || field.kind == FieldKind::choice;
    if (takes_numbers && is_all_numbers(list)) {
        std::vector<double> numbers;
        for (const Value& x : list) numbers.push_back(x.number());
        return numbers;
    }
    if (field.takes_file) {
        if (std::optional<Points> rows = rows_in(field, list)) return *std::move(rows);
    }
    if (field.kind != FieldKind::list) refuse_value(field, "a list");
    std::string text;
    for (const Value& x : list) text += (text.empty() ? "" : ",") + typed_text(field, x);
    return text;
}

Table table_of(const Value& value, const std::string& name) {
    return parse_table({name, dump_json(value, JsonStyle::one_line)}, TableFormat::json);
}

/// Rows of heights, one row an x, `null` where a node is missing; lines are counted from 0.
GridFile grid_of(const ValueList& rows, const std::string& name) {
    const ValueList* first = rows.empty() ? nullptr : rows.front().list();
    Grid z(rows.size(), first ? first->size() : 0);
    for (std::size_t i = 0; i < z.nu(); ++i) {
        const ValueList* row = rows[i].list();
        const std::string place = name + " row " + std::to_string(i);
        if (!row || row->size() != z.nv()) {
            throw Error("grid.ragged", place, row ? std::to_string(row->size()) : "no list",
                        "every row of a grid must have as many heights as the first");
        }
        for (std::size_t j = 0; j < z.nv(); ++j) {
            if ((*row)[j].is_null()) {
                z.drop(i, j);
            } else if ((*row)[j].is_number()) {
                z(i, j) = (*row)[j].number();
            } else {
                throw Error("grid.cell", place + ", column " + std::to_string(j), "something else",
                            "a height must be a number or null");
            }
        }
    }
    return counted_grid(std::move(z), name);
}

/// One curve, or several.
Input curves_input(std::vector<Curve> curves, const std::string& name) {
    if (curves.size() == 1) return {name, std::move(curves.front())};
    return {name, std::move(curves)};
}

}  // namespace

std::vector<int> columns_for(const Field& field, const Table& table) {
    if (field.kind != FieldKind::table) return coordinate_columns(table);
    std::vector<int> all(static_cast<std::size_t>(table.columns()));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

std::vector<int> columns_beside(const Curve& curve, const Table& table) {
    if (api::function_of(curve) && table.columns() > 2) {
        const auto [x, y] = api::function_columns(table, {});
        return {x, y};
    }
    const bool is_plane = api::has_column(table, "x") && api::has_column(table, "y") &&
                          !api::has_column(table, "z");
    if (curve.dim() == 2 && is_plane) return coordinate_columns(table, "x,y");
    return coordinate_columns(table);
}

Argument argument_of(const Field& field, const Value& value) {
    const bool takes_rows = field.kind == FieldKind::table || field.kind == FieldKind::shape;
    if (const ValueList* list = value.list()) {
        if (!takes_rows) return list_argument(field, *list);
        const Table table = table_of(value, field.name);
        if (table.columns() == 1) return Points(column_values(table, 0), 1);
        return points_of(table, columns_for(field, table));
    }
    if (value.map()) {
        if (field.kind != FieldKind::shape) refuse_value(field, "a map");
        return curve_of(value, field.name);
    }
    return typed_text(field, value);
}

Input input_of(Table table, const Operation& operation, const std::string& picks) {
    std::vector<int> columns;
    if (operation.input != InputKind::table || !picks.empty()) {
        columns = coordinate_columns(table, picks);
    }
    std::string name = table.source;
    return {std::move(name), PointsInput{std::move(table), std::move(columns)}};
}

Input input_of(const Value& value, const std::string& name, const Operation& operation,
               const std::string& picks) {
    if (is_surface(value)) return {name, any_surface_of(value, name)};
    if (value.map()) return curves_input(curves_of(value, name), name);
    if (operation.input == InputKind::grid && value.list()) {
        return {name, grid_of(*value.list(), name)};
    }
    return input_of(table_of(value, name), operation, picks);
}

Input input_of(const Outcome& made, const std::string& name, const Operation& operation,
               const std::string& picks) {
    const Output& output = made.output;
    if (!made.curves.empty() && takes_curve(operation.input)) {
        return curves_input(made.curves, name);
    }
    if (const Curve* curve = std::get_if<Curve>(&output)) return {name, *curve};
    if (const Surface* surface = std::get_if<Surface>(&output)) return {name, *surface};
    const Rows* rows = std::get_if<Rows>(&output);
    if (!rows) {
        throw Error("job.input", name, "no curve, rows or surface",
                    "this step makes no input of others");
    }
    if (operation.input == InputKind::grid) {
        return {name, Source{name, csv_points(rows->cells, rows->names)}};
    }
    Table table;
    table.source = name;
    table.names = rows->names;
    table.cells = rows->cells;
    table.bad.resize(static_cast<std::size_t>(table.columns()));
    return input_of(std::move(table), operation, picks);
}

Argument argument_of(const Outcome& made, const std::string& name) {
    if (const Curve* curve = std::get_if<Curve>(&made.output)) return *curve;
    if (!made.curves.empty()) return one_curve(made.curves, name);
    if (const Rows* rows = std::get_if<Rows>(&made.output)) return rows->cells;
    throw Error("job.input", name, "no curve and no rows", "this step makes no input of others");
}

}  // namespace batten
