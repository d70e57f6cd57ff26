#include "api/row.hpp"

#include <string>

#include "batten/base/error.hpp"
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

}  // namespace

const Curve& curve_input(std::span<const Input> inputs) {
    const Curve* curve = std::get_if<Curve>(&single(inputs).content);
    if (!curve) {
        throw Error("input.kind", "input", "no curve", "this operation takes a curve");
    }
    return *curve;
}

const PointsInput& points_input(std::span<const Input> inputs) {
    const PointsInput* points = std::get_if<PointsInput>(&single(inputs).content);
    if (!points) throw Error("input.kind", "input", "a curve", "this operation takes points");
    return *points;
}

const Surface& surface_input(std::span<const Input> inputs) {
    const Surface* surface = std::get_if<Surface>(&single(inputs).content);
    if (!surface) throw Error("input.kind", "input", "no surface", "this operation takes a surface");
    return *surface;
}

const SplineSurface& product_input(std::span<const Input> inputs) {
    const SplineSurface* surface = std::get_if<SplineSurface>(&surface_input(inputs));
    if (!surface) {
        throw Error("input.kind", "input", "a surface with curved knot lines",
                    "this operation takes a tensor product");
    }
    return *surface;
}

GridFile grid_input(std::span<const Input> inputs) {
    const Input& input = single(inputs);
    if (const GridFile* grid = std::get_if<GridFile>(&input.content)) return *grid;
    const Source* source = std::get_if<Source>(&input.content);
    if (!source) throw Error("input.kind", "input", "no grid", "this operation takes a grid");
    return parse_grid(*source);
}

PointsInput rows_input(std::span<const Input> inputs) {
    const Input& input = single(inputs);
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

Points points_of(const PointsInput& input) {
    if (!input.borrowed) return batten::points_of(input.table, input.columns);
    require_finite(*input.borrowed);
    return Points(*input.borrowed);
}

std::vector<std::string> names_given(const PointsInput& input) {
    if (input.borrowed) return coordinate_names(input.borrowed->dim());
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
