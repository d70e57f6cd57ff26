#include "batten/make/interpolate.hpp"

#include "api/row.hpp"

namespace batten::api {
namespace {

Drawing picture(PointsView points, const Curve& curve, const InterpolateOptions& options) {
    Drawing drawing;
    if (curve.dim() == 2) drawing.add(CombLayer{curve, "curvature"});
    drawing.add(CurveLayer{curve, std::string(name_of(options.method)), {}});
    drawing.add(PointsLayer{Points(points), "points", Marker::open, options.corner});
    return drawing;
}

Outcome run(std::span<const Input> inputs, const InterpolateOptions& options) {
    const PointsInput& input = points_input(inputs);
    const SharedPoints points = points_of(input);
    Interpolation made = naming_lines(input, [&] { return interpolate(points, options); });
    made.report.notes.insert(made.report.notes.begin(), input.table.notes.begin(),
                             input.table.notes.end());
    return {made.curve, made.report.status, {}, report_value(made.report),
            [points, made, options] { return picture(points, made.curve, options); }};
}

}  // namespace

Operation interpolate_row() {
    return row<InterpolateOptions>(
        {"interpolate", "a fair curve exactly through points", InputKind::points,
         OutputKind::curve},
        run);
}

}  // namespace batten::api
