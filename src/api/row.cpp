#include "api/row.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/table.hpp"
#include "batten/io/write_points.hpp"
#include "batten/shape/spline_graph.hpp"

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

std::vector<std::string> forms_of(OutputKind kind, const std::vector<std::string_view>& more) {
    std::vector<std::string> forms;
    switch (kind) {
        case OutputKind::report: forms = {"json"}; break;
        case OutputKind::curve: forms = {"json", "svg", "csv", "dxf"}; break;
        case OutputKind::rows: forms = {"csv", "json", "npy"}; break;
        case OutputKind::drawing: forms = {"svg", "png", "pdf"}; break;
        case OutputKind::surface: forms = {"json"}; break;
        case OutputKind::curves: forms = {"csv", "json", "npy", "svg", "dxf"}; break;
    }
    forms.insert(forms.end(), more.begin(), more.end());
    return forms;
}

void require_no_jumps(std::span<const Input> inputs, const std::vector<Setting>& settings) {
    const auto require_none = [](const Curve* curve, const std::string& name) {
        if (!curve || !has_jumps(*curve)) return;
        throw Error("curve.jumps", name, "a spline with jumps",
                    "this operation follows curves without jumps; evaluate and draw take it");
    };
    for (const Input& input : inputs) require_none(std::get_if<Curve>(&input.content), input.name);
    for (const Setting& each : settings) require_none(std::get_if<Curve>(&each.value), each.name);
}

const Curve& curve_input(std::span<const Input> inputs) {
    const Input& input = single(inputs);
    const Curve* curve = std::get_if<Curve>(&input.content);
    if (!curve) throw Error("input.kind", input.name, "no curve", "this operation takes a curve");
    return *curve;
}

const PointsInput& points_input(std::span<const Input> inputs) {
    const Input& input = single(inputs);
    const PointsInput* points = std::get_if<PointsInput>(&input.content);
    if (!points) throw Error("input.kind", input.name, "a curve", "this operation takes points");
    return *points;
}

const Surface& surface_input(std::span<const Input> inputs) {
    const Surface* surface = std::get_if<Surface>(&single(inputs).content);
    if (!surface) throw Error("input.kind", "input", "no surface", "this operation takes a surface");
    return *surface;
}

GridFile grid_input(std::span<const Input> inputs) {
    const Input& input = single(inputs);
    if (const GridFile* grid = std::get_if<GridFile>(&input.content)) return *grid;
    if (const StoredFile* file = std::get_if<StoredFile>(&input.content)) {
        return read_grid(file->path);
    }
    const Source* source = std::get_if<Source>(&input.content);
    if (!source) throw Error("input.kind", "input", "no grid", "this operation takes a grid");
    return parse_grid(*source);
}

GridStream grid_stream_input(std::span<const Input> inputs) {
    const Input& input = single(inputs);
    if (const StoredFile* file = std::get_if<StoredFile>(&input.content)) {
        return GridStream(StoredBytes(file->path));
    }
    if (const Source* source = std::get_if<Source>(&input.content)) {
        return GridStream(StoredBytes(*source));
    }
    throw Error("grid.streamed", input.name, "a grid in memory", "a file is read in blocks");
}

PointsInput rows_input(std::span<const Input> inputs) {
    const Input& input = single(inputs);
    if (const StoredFile* file = std::get_if<StoredFile>(&input.content)) {
        return {read_table(file->path), {}};
    }
    if (const Source* source = std::get_if<Source>(&input.content)) return {parse_table(*source), {}};
    if (const GridFile* grid = std::get_if<GridFile>(&input.content)) {
        // Rows of three or four numbers, given as an array.
        Table table;
        table.source = input.name;
        table.cells = Points(grid->z.nu(), static_cast<int>(grid->z.nv()));
        table.bad.resize(grid->z.nv());
        for (std::size_t i = 0; i < grid->z.nu(); ++i) {
            for (std::size_t j = 0; j < grid->z.nv(); ++j) {
                table.cells[i][j] = grid->z(i, j);
                if (!grid->z.has(i, j) && !table.bad[j]) table.bad[j] = {i, "nan"};
            }
        }
        return {std::move(table), {}};
    }
    return points_input(inputs);
}

SharedPoints points_of(const PointsInput& input) {
    if (!input.borrowed) return SharedPoints(batten::points_of(input.table, input.columns));
    require_finite(*input.borrowed);
    return *input.borrowed;
}

namespace {

/// One column's numbers, read by `read` where they stand in a table; numbers in memory that
/// `is_usable` refuses are shown to it too, for its error.
template <class IsUsable, class Read>
SharedNumbers numbers_in(const PointsInput& input, int column, IsUsable is_usable, Read read) {
    const bool is_table = !input.borrowed && input.shared_columns.empty();
    if (is_table) return SharedNumbers(read(input.table, column));
    const std::size_t at = static_cast<std::size_t>(column);
    const SharedNumbers numbers =
        input.borrowed ? gathered(*input.borrowed, column) : input.shared_columns[at];
    for (std::size_t row = 0; row < numbers.size(); ++row) {
        if (is_usable(numbers[row])) continue;
        Table refused = input.table;
        refused.mark_bad(at, numbers[row], {row, format_number(numbers[row])});
        read(refused, column);  // throws
    }
    return numbers;
}

}  // namespace

SharedNumbers column_in(const PointsInput& input, int column) {
    return numbers_in(input, column, [](double x) { return std::isfinite(x); }, column_values);
}

SharedNumbers errors_in(const PointsInput& input, int column) {
    const auto is_usable = [](double x) {
        return std::isfinite(x) || x == std::numeric_limits<double>::infinity();
    };
    return numbers_in(input, column, is_usable, column_errors);
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
