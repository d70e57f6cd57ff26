#include "batten/make/convert.hpp"

#include "api/machine_options.hpp"
#include "api/row.hpp"

namespace batten::api {
namespace {

struct ConvertRequest {
    ConvertOptions convert;
    MachineOptions machine;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, ConvertRequest>
void visit_fields(Options& o, Visit&& visit) {
    visit_fields(o.convert, visit);
    visit_fields(o.machine, visit);
}

Drawing picture(const Curve& before, const Curve& after) {
    Drawing drawing;
    drawing.add(CurveLayer{before, "as read", {Tone::grey, Dash::solid, 3.0}});
    drawing.add(CurveLayer{after, "converted", {Tone::blue, Dash::solid, 1.3}});
    return drawing;
}

Outcome run(std::span<const Input> inputs, const ConvertRequest& request) {
    const Curve& curve = curve_input(inputs);
    const Conversion made = convert(curve, request.convert);
    return {made.curve, made.report.status, {}, report_value(made.report),
            [curve, made] { return picture(curve, made.curve); },
            machine_forms(made.curve, request.machine)};
}

}  // namespace

Operation convert_row() {
    return row<ConvertRequest>(
        {"convert", "other forms of a curve, trimmed, reversed or scaled", InputKind::curve,
         OutputKind::curve},
        run);
}

}  // namespace batten::api
