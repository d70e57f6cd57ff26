#include "batten/measure/compare.hpp"

#include "api/row.hpp"
#include "api/spline_panel.hpp"
#include "batten/base/error.hpp"

namespace batten::api {
namespace {

Drawing picture(const Curve& curve, const std::variant<Points, Curve>& other,
                const CompareReport& report) {
    Drawing drawing;
    const auto* other_curve = std::get_if<Curve>(&other);
    if (function_of(curve) && (!other_curve || function_of(*other_curve))) {
        const AxisNames names;
        drawing.panels.front() = chart({}, names.x, names.y);
    }
    drawing.add(CurveLayer{curve, "curve", {}});
    if (other_curve) {
        drawing.add(CurveLayer{*other_curve, "compared with", {}});
    } else {
        drawing.add(PointsLayer{std::get<Points>(other), "compared with"});
    }
    Points farthest(0, curve.dim());
    farthest.push_back(report.at.point);
    drawing.add(PointsLayer{farthest, "largest deviation", Marker::closed, {}, PointLabels::none,
                            Tone::accent});
    return drawing;
}

Outcome run(std::span<const Input> inputs, const CompareOptions& options) {
    const Curve& curve = curve_input(inputs);
    const Points* points = std::get_if<Points>(&options.to);
    if (points && points->empty()) {
        throw Error("option.missing", "to", "not given", "names the points or curve to compare with");
    }
    const CompareReport report = compare(curve, options);
    const auto other = options.to;
    return {{}, report.status, {}, report_value(report),
            [curve, other, report] { return picture(curve, other, report); }};
}

}  // namespace

Operation compare_row() {
    return row<CompareOptions>({"compare", "signed deviation of points or another curve",
                                InputKind::curve, OutputKind::report},
                               run);
}

}  // namespace batten::api
