#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include "api/curve_layers.hpp"
#include "api/knot_marks.hpp"
#include "api/row.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/spline_function.hpp"
#include "batten/shape/surface.hpp"

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

Drawing section_picture(const SplineFunction& cut, const Curve& curve,
                        const SectionOptions& options) {
    const std::string line =
        options.x ? "x = " + format_number(*options.x) : "y = " + format_number(*options.y);
    std::vector<double> heights;
    const Interval domain = cut.domain();
    constexpr int places = 1000;
    for (int i = 0; i <= places; ++i) {
        heights.push_back(cut(domain.clamp(domain.lo + domain.length() * (i / double{places}))));
    }
    const Interval extent = extent_of(heights);
    Drawing drawing;
    drawing.title = "Section of the surface at " + line;
    add_parts(drawing, curve);
    Panel& panel = drawing.panels.front();
    panel.kind = PanelKind::chart;
    panel.x_label = options.x ? "y" : "x";
    panel.y_label = "z";
    add_knot_marks(panel, cut, widened(extent, extent, 0));
    return drawing;
}

/// Heights along the line; of a piece at both its ends, so that a jump is two rows.
Rows section_rows(const SplineFunction& cut, const char* along) {
    constexpr int samples_a_piece = 16;
    constexpr double rounding = 1e-12;
    Rows rows{{along, "z"}, Points(0, 2)};
    double size = 0, last = std::numeric_limits<double>::quiet_NaN();
    for (const double c : cut.coefficients()) size = std::max(size, std::fabs(c));
    for (std::size_t i = 0; i < cut.pieces(); ++i) {
        const double from = cut.breaks()[i], to = cut.breaks()[i + 1];
        const int steps = cut.degree() > 1 ? samples_a_piece : 1;
        for (int k = 0; k <= steps; ++k) {
            const double at = k == steps ? to : from + (to - from) * k / steps;
            const double z = cut.value_on(i, at, 0);
            if (k == 0 && std::fabs(z - last) <= rounding * size) continue;
            rows.cells.push_back(std::array{at, z});
            last = z;
        }
    }
    return rows;
}

Outcome run(std::span<const Input> inputs, const SectionOptions& options) {
    const Surface& surface = surface_input(inputs);
    if (options.x.has_value() == options.y.has_value()) {
        throw Error("surface.section", "section", options.x ? "x and y" : "neither x nor y",
                    "one of x and y tells where to cut");
    }
    const SplineFunction cut =
        options.x ? section_at_x(surface, *options.x) : section_at_y(surface, *options.y);
    const Curve curve = graph_in_parts(cut);
    const SectionReport report{options.x ? "z(y)" : "z(x)",
                               {cut.breaks().begin(), cut.breaks().end()}};
    return {curve, Status::met, {}, report_value(report), [cut, curve, options] {
                return section_picture(cut, curve, options);
            },
            {}, [cut, options] { return section_rows(cut, options.x ? "y" : "x"); }, {},
            MadeSpline{cut}};
}

}  // namespace

Operation section_row() {
    return row<SectionOptions>({"section", "a surface cut along a line of constant x or y",
                                InputKind::surface, OutputKind::curve, {"npy"}},
                               run);
}

}  // namespace batten::api
