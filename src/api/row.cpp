#include "api/row.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/table.hpp"
#include "batten/io/write_points.hpp"

namespace batten::api {
namespace {

const Input& single(std::span<const Input> inputs) {
    if (inputs.size() != 1) {
        throw Error("input.count", "input", std::to_string(inputs.size()),
                    "this operation takes one input");
    }
    return inputs.front();
}

SharedNumbers gathered(PointsView rows, int column) {
    std::vector<double> numbers(rows.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = rows(i, column);
    return SharedNumbers(std::move(numbers));
}

}  // namespace

const Curve& curve_input(std::span<const Input> inputs) {
    const Curve* curve = std::get_if<Curve>(&single(inputs).content);
    if (!curve) throw Error("input.kind", "input", "points", "this operation takes a curve");
    return *curve;
}

const PointsInput& points_input(std::span<const Input> inputs) {
    const PointsInput* points = std::get_if<PointsInput>(&single(inputs).content);
    if (!points) throw Error("input.kind", "input", "a curve", "this operation takes points");
    return *points;
}

SharedPoints points_of(const PointsInput& input) {
    if (!input.borrowed) return SharedPoints(batten::points_of(input.table, input.columns));
    require_finite(*input.borrowed);
    return *input.borrowed;
}

SharedNumbers column_in(const PointsInput& input, int column) {
    const bool is_table = !input.borrowed && input.shared_columns.empty();
    if (is_table) return SharedNumbers(column_values(input.table, column));
    const std::size_t at = static_cast<std::size_t>(column);
    const SharedNumbers numbers =
        input.borrowed ? gathered(*input.borrowed, column) : input.shared_columns[at];
    for (std::size_t row = 0; row < numbers.size(); ++row) {
        if (std::isfinite(numbers[row])) continue;
        Table refused = input.table;
        refused.bad[at] = {row, format_number(numbers[row])};
        column_values(refused, column);  // throws
    }
    return numbers;
}

std::vector<std::string> names_given(const PointsInput& input) {
    if (input.borrowed && input.columns.empty()) return coordinate_names(input.borrowed->dim());
    if (input.table.names.empty()) return coordinate_names(static_cast<int>(input.columns.size()));
    std::vector<std::string> names;
    for (const int column : input.columns) {
        names.push_back(input.table.names[static_cast<std::size_t>(column)]);
    }
    return names;
}

Error with_lines(const Error& error, const PointsInput& input) {
    if (error.code().rfind("points.", 0) != 0 && error.rows().empty()) return error;
    if (error.rows().empty()) return error.at(input.table.source);
    std::string place = input.table.source;
    if (input.table.line_of_row.empty()) return error.at(place + ' ' + error.place());
    place += error.rows().size() > 1 ? " rows" : " row";
    for (std::size_t i = 0; i < error.rows().size(); ++i) {
        place += (i > 0 ? " and " : " ") + std::to_string(input.table.line_of_row[error.rows()[i]]);
    }
    const std::size_t column = error.place().find(", column ");
    if (column != std::string::npos) place += error.place().substr(column);
    return error.at(place);
}

}  // namespace batten::api
