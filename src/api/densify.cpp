#include "batten/make/densify.hpp"

#include <utility>

#include "api/row.hpp"

namespace batten::api {
namespace {

Drawing picture(PointsView given, const Densified& made, const DensifyOptions& options) {
    Drawing drawing;
    Points corners(given);
    if (options.closed) corners.push_back(given[0]);
    drawing.add(PolylineLayer{{corners}, "chords of the points given",
                              {Tone::grey, Dash::dashed, 1.0}});
    drawing.add(CurveLayer{made.curve, "interpolating curve", {Tone::blue, Dash::solid, 1.3}});
    drawing.add(PointsLayer{made.points, "new points", Marker::closed, {}, PointLabels::none,
                            Tone::blue});
    drawing.add(PointsLayer{Points(given), "points given"});
    return drawing;
}

Outcome run(std::span<const Input> inputs, const DensifyOptions& options) {
    const PointsInput& input = points_input(inputs);
    const SharedPoints points = points_of(input);
    Densified made = naming_lines(input, [&] { return densify(points, options); });
    made.report.notes.insert(made.report.notes.begin(), input.table.notes.begin(),
                             input.table.notes.end());
    return {Rows{names_given(input), made.points}, made.report.status, {},
            report_value(made.report),
            [points, made, options] { return picture(points, made, options); }};
}

}  // namespace

Operation densify_row() {
    return row<DensifyOptions>({"densify", "more points between points, by moving windows",
                                InputKind::points, OutputKind::rows},
                               run);
}

}  // namespace batten::api
