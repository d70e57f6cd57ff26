#include "batten/make/convert.hpp"

#include "api/row.hpp"

namespace batten::api {
namespace {

Drawing picture(const Curve& before, const Curve& after) {
    Drawing drawing;
    drawing.add(CurveLayer{before, "as read", {Tone::grey, Dash::solid, 3.0}});
    drawing.add(CurveLayer{after, "converted", {Tone::blue, Dash::solid, 1.3}});
    return drawing;
}

Outcome run(std::span<const Input> inputs, const ConvertOptions& options) {
    const Curve& curve = curve_input(inputs);
    const Conversion made = convert(curve, options);
    return {made.curve, made.report.status, {}, report_value(made.report),
            [curve, made] { return picture(curve, made.curve); }};
}

}  // namespace

Operation convert_row() {
    return row<ConvertOptions>(
        {"convert", "other forms of a curve, trimmed, reversed or scaled", InputKind::curve,
         OutputKind::curve},
        run);
}

}  // namespace batten::api
