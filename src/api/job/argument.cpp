#include "batten/api/argument.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/table.hpp"

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

Argument list_argument(const Field& field, const ValueList& list) {
    const bool takes_numbers = field.takes_file || field.kind == FieldKind::choice;
    if (takes_numbers && is_all_numbers(list)) {
        std::vector<double> numbers;
        for (const Value& x : list) numbers.push_back(x.number());
        return numbers;
    }
    if (field.kind != FieldKind::list) refuse_value(field, "a list");
    std::string text;
    for (const Value& x : list) text += (text.empty() ? "" : ",") + typed_text(field, x);
    return text;
}

Table table_of(const Value& value, const std::string& name) {
    return parse_table({name, dump_json(value, JsonStyle::one_line)}, TableFormat::json);
}

}  // namespace

Argument argument_of(const Field& field, const Value& value) {
    const bool takes_rows = field.kind == FieldKind::table || field.kind == FieldKind::shape;
    if (const ValueList* list = value.list()) {
        if (!takes_rows) return list_argument(field, *list);
        const Table table = table_of(value, field.name);
        if (table.columns() == 1) return Points(column_values(table, 0), 1);
        return points_of(table, coordinate_columns(table));
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
    if (value.map()) return {name, curve_of(value, name)};
    return input_of(table_of(value, name), operation, picks);
}

Input input_of(const Output& output, const std::string& name, const Operation& operation,
               const std::string& picks) {
    if (const Curve* curve = std::get_if<Curve>(&output)) return {name, *curve};
    const Rows* rows = std::get_if<Rows>(&output);
    if (!rows) {
        throw Error("job.input", name, "no curve and no rows", "this step makes no input of others");
    }
    Table table;
    table.source = name;
    table.names = rows->names;
    table.cells = rows->cells;
    table.bad.resize(static_cast<std::size_t>(table.columns()));
    return input_of(std::move(table), operation, picks);
}

}  // namespace batten
