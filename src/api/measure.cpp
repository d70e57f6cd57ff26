#include "batten/measure/measure.hpp"

#include "api/row.hpp"
#include "api/spline_panel.hpp"
#include "api/surface_picture.hpp"
#include "batten/measure/surface_measures.hpp"

namespace batten::api {
namespace {

Drawing picture(const Curve& curve) {
    Drawing drawing;
    const bool is_function = function_of(curve).has_value();
    if (is_function) {
        const AxisNames names;
        drawing.panels.front() = chart({}, names.x, names.y);
    } else if (curve.dim() == 2) {
        drawing.add(CombLayer{curve, "curvature"});
    }
    drawing.add(CurveLayer{curve, {}, {}});
    drawing.panels.front().caption = "curve";
    drawing.panels.push_back(curvature_plot(curve));
    drawing.panels.back().caption = "curvature along it";
    return drawing;
}

/// The area of a surface costs more than the length of a curve: less is asked of it.
constexpr Tolerance usual_area_tolerance = relative(1e-9);

Outcome run(std::span<const Input> inputs, const MeasureOptions& options) {
    if (inputs.size() == 1 && std::holds_alternative<Surface>(inputs.front().content)) {
        const Surface& surface = surface_input(inputs);
        const bool is_usual = options.tolerance == MeasureOptions{}.tolerance;
        const SurfaceReport report =
            measure_surface(surface, is_usual ? usual_area_tolerance : options.tolerance);
        return {{}, report.status, {}, report_value(report), [surface] {
                    return surface_picture(surface, usual_levels);
                }};
    }
    const Curve& curve = curve_input(inputs);
    const MeasureReport report = measure(curve, options);
    return {{}, report.status, {}, report_value(report), [curve] { return picture(curve); }};
}

}  // namespace

Operation measure_row() {
    return row<MeasureOptions>(
        {"measure", "length, area, energy, curvature and joints of a curve; area, volume and bends of a surface",
         InputKind::curve_or_surface, OutputKind::report},
        run);
}

}  // namespace batten::api
