#include "batten/make/convert.hpp"

#include "api/machine_options.hpp"
#include "api/row.hpp"
#include "api/surface_picture.hpp"
#include "api/surface_values.hpp"
#include "batten/base/error.hpp"
#include "batten/io/write_points.hpp"

namespace batten::api {
namespace {

struct ConvertRequest {
    ConvertOptions convert;
    MachineOptions machine;
    std::optional<int> count;
    std::optional<int> only;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, ConvertRequest>
void visit_fields(Options& o, Visit&& visit) {
    visit_fields(o.convert, visit);
    visit_fields(o.machine, visit);
    visit("count", o.count, between(2, 10000),
          "of a surface: lines each way of the grid or mesh that is written [65]");
    visit("only", o.only, at_least(0), "of a file of several curves: this one, counted from 0");
}

Drawing picture(const Curve& before, const Curve& after) {
    Drawing drawing;
    drawing.add(CurveLayer{before, "as read", {Tone::grey, Dash::solid, 3.0}});
    drawing.add(CurveLayer{after, "converted", {Tone::blue, Dash::solid, 1.3}});
    return drawing;
}

struct SurfaceForm {
    std::string kind;
};

template <class Visit>
void visit_fields(const SurfaceForm& r, Visit&& visit) {
    visit("kind", r.kind, "what the surface is");
}

constexpr int usual_count = 65;

Outcome run_surface(const Surface& surface, const ConvertRequest& request) {
    const ConvertOptions& o = request.convert;
    const bool asks_curve = o.as != Form::same || o.reverse || o.trim || o.scale ||
                            !o.insert_knots.empty() || o.elevate > 0 || o.remove_knots;
    if (asks_curve) {
        throw Error("surface.option", "convert", "as, reverse, trim, scale, knots or degree",
                    "these are for curves; a surface takes count and format");
    }
    const auto count = static_cast<std::size_t>(request.count.value_or(usual_count));
    const Rectangle domain = domain_of(surface);
    const bool is_product = std::holds_alternative<SplineSurface>(surface);
    return {surface, Status::met, {},
            report_value(SurfaceForm{is_product ? "b-spline-graph" : "curved-knots"}),
            [surface] { return surface_picture(surface, usual_levels); },
            surface_forms(surface, even_places(domain.x, count), even_places(domain.y, count))};
}

/// The polynomials of each piece: `x2` is the coefficient of (t - from)^2 in x.
Rows power_rows(const Curve& curve) {
    Rows rows{{"from", "to"}, power_form(curve)};
    for (const std::string& axis : coordinate_names(curve.dim())) {
        for (int j = 0; j <= *curve.degree(); ++j) rows.names.push_back(axis + std::to_string(j));
    }
    return rows;
}

Outcome run(std::span<const Input> inputs, const ConvertRequest& request) {
    if (inputs.size() == 1) {
        if (const auto* surface = std::get_if<Surface>(&inputs.front().content)) {
            return run_surface(*surface, request);
        }
    }
    if (request.count) {
        throw Error("option.unused", "count", std::to_string(*request.count),
                    "tells the lines of a surface; `sample` and `evaluate` take points of a curve");
    }
    const Curve& curve = curve_input(inputs);
    const Conversion made = convert(curve, request.convert);
    const bool is_power = request.convert.as == Form::power;
    Output output = is_power ? Output(power_rows(made.curve)) : Output(made.curve);
    return {std::move(output), made.report.status, {}, report_value(made.report),
            [curve, made] { return picture(curve, made.curve); },
            is_power ? std::vector<OutputForm>() : machine_forms(made.curve, request.machine)};
}

}  // namespace

Operation convert_row() {
    return row<ConvertRequest>(
        {"convert", "other forms, knots and degrees of a curve or surface, trimmed, reversed or scaled",
         InputKind::curve_or_surface,
         OutputKind::curve, {"gcode", "npy", "obj", "patches", "ply", "stl"}},
        run);
}

}  // namespace batten::api
