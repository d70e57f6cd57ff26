#include "batten/make/thin.hpp"

#include <utility>

#include "api/row.hpp"

namespace batten::api {
namespace {

/// The curve that the kept points give back.
Curve curve_again(const Points& kept, const ThinOptions& options) {
    DensifyOptions same;
    same.degree = options.degree;
    same.end_degree = options.end_degree;
    same.parameter = options.parameter;
    same.closed = options.closed;
    same.between = 0;
    return densify(kept, same).curve;
}

Drawing picture(PointsView given, const Thinned& thinned, const ThinOptions& options) {
    Drawing drawing;
    drawing.add(PointsLayer{Points(given), "points given", Marker::closed, {}, PointLabels::none,
                            Tone::grey});
    drawing.add(CurveLayer{curve_again(thinned.points, options), "curve of the points kept",
                           {Tone::blue, Dash::solid, 1.3}});
    // Full dots: rings would hide the curve inside them.
    drawing.add(PointsLayer{thinned.points, "points kept", Marker::closed, {}, PointLabels::none,
                            Tone::accent});
    return drawing;
}

/// The rows kept, with those of the other named columns that hold nothing but numbers.
Rows rows_kept(const PointsInput& input, const Thinned& thinned) {
    const Table& table = input.table;
    if (table.names.empty()) return {names_given(input), thinned.points};
    std::vector<int> columns;
    std::vector<std::string> names;
    for (int column = 0; column < table.columns(); ++column) {
        if (table.bad[static_cast<std::size_t>(column)]) continue;
        columns.push_back(column);
        names.push_back(table.names[static_cast<std::size_t>(column)]);
    }
    Points cells(thinned.kept.size(), static_cast<int>(columns.size()));
    for (std::size_t row = 0; row < thinned.kept.size(); ++row) {
        for (std::size_t k = 0; k < columns.size(); ++k) {
            cells(row, static_cast<int>(k)) = table.cells(thinned.kept[row], columns[k]);
        }
    }
    return {std::move(names), std::move(cells)};
}

Outcome run(std::span<const Input> inputs, const ThinOptions& options) {
    const PointsInput& input = points_input(inputs);
    const SharedPoints points = points_of(input);
    Thinned thinned = naming_lines(input, [&] { return thin(points, options); });
    thinned.report.notes.insert(thinned.report.notes.begin(), input.table.notes.begin(),
                                input.table.notes.end());
    return {rows_kept(input, thinned), thinned.report.status, {},
            report_value(thinned.report),
            [points, thinned, options] { return picture(points, thinned, options); }};
}

}  // namespace

Operation thin_row() {
    return row<ThinOptions>({"thin", "the fewest points from which densify makes the curve again",
                             InputKind::points, OutputKind::rows},
                            run);
}

}  // namespace batten::api
