#include "batten/measure/measure.hpp"

#include "api/row.hpp"

namespace batten::api {
namespace {

Drawing picture(const Curve& curve) {
    Drawing drawing;
    if (curve.dim() == 2) drawing.add(CombLayer{curve, "curvature"});
    drawing.add(CurveLayer{curve, {}, {}});
    drawing.panels.front().caption = "curve";
    drawing.panels.push_back(curvature_plot(curve));
    drawing.panels.back().caption = "curvature along it";
    return drawing;
}

Outcome run(std::span<const Input> inputs, const MeasureOptions& options) {
    const Curve& curve = curve_input(inputs);
    const MeasureReport report = measure(curve, options);
    return {{}, report.status, {}, report_value(report), [curve] { return picture(curve); }};
}

}  // namespace

Operation measure_row() {
    return row<MeasureOptions>(
        {"measure", "length, area, energy, curvature and joints of a curve, with their errors",
         InputKind::curve, OutputKind::report},
        run);
}

}  // namespace batten::api
