#include "batten/make/log_aesthetic.hpp"

#include "api/row.hpp"

namespace batten::api {
namespace {

Drawing picture(const LogAestheticCurve& arc, const LogAestheticOptions& options) {
    const Points corners(options.points, 2);
    Drawing drawing;
    drawing.add(PolylineLayer{{corners}, "control points", {Tone::grey, Dash::dashed, 1}});
    drawing.add(CombLayer{arc, "curvature"});
    drawing.add(CurveLayer{arc, "log-aesthetic segment"});
    drawing.add(PointsLayer{corners});
    return drawing;
}

Outcome run(std::span<const Input>, const LogAestheticOptions& options) {
    const LogAestheticMade made = log_aesthetic(options);
    Outcome outcome{{}, made.report.status, {}, report_value(made.report), {}};
    if (made.curve) {
        outcome.output = Curve(*made.curve);
        outcome.draw = [arc = *made.curve, options] { return picture(arc, options); };
    }
    return outcome;
}

}  // namespace

Operation log_aesthetic_row() {
    return row<LogAestheticOptions>(
        {"log-aesthetic", "one log-aesthetic segment from three control points", InputKind::none,
         OutputKind::curve},
        run);
}

}  // namespace batten::api
