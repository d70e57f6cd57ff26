#include <concepts>
#include <optional>

#include "api/row.hpp"
#include "batten/shape/spline_function.hpp"

namespace batten::api {
namespace {

struct SectionOptions {
    std::optional<double> x, y;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, SectionOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("x", o.x, anything, "cut along the line of this x: the curve is z(y)");
    visit("y", o.y, anything, "cut along the line of this y: the curve is z(x)");
}

struct SectionReport {
    std::string of;
    std::vector<double> breaks;
};

template <class Visit>
void visit_fields(const SectionReport& r, Visit&& visit) {
    visit("of", r.of, "what the curve's second coordinate is of its first");
    visit("breaks", r.breaks, "where pieces of the curve meet");
}

Outcome run(std::span<const Input> inputs, const SectionOptions& options) {
    const SplineSurface& surface = product_input(inputs);
    if (options.x.has_value() == options.y.has_value()) {
        throw Error("surface.section", "section", options.x ? "x and y" : "neither x nor y",
                    "one of x and y tells where to cut");
    }
    const SplineFunction cut =
        options.x ? section_at_x(surface, *options.x) : section_at_y(surface, *options.y);
    const Curve curve = graph(cut.degree() == 0 ? elevate_degree(cut) : cut);
    const SectionReport report{options.x ? "z(y)" : "z(x)",
                               {cut.breaks().begin(), cut.breaks().end()}};
    return {curve, Status::met, {}, report_value(report), [curve] {
                Drawing drawing;
                drawing.add(CurveLayer{curve, {}, {}});
                return drawing;
            },
            {}, {}, {}, MadeSpline{cut}};
}

}  // namespace

Operation section_row() {
    return row<SectionOptions>({"section", "a surface cut along a line of constant x or y",
                                InputKind::surface, OutputKind::curve},
                               run);
}

}  // namespace batten::api
