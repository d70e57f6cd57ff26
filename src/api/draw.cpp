#include "batten/io/draw/drawing.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <optional>
#include <string>

#include "api/curve_layers.hpp"
#include "api/fit_table.hpp"
#include "api/row.hpp"
#include "api/spline_panel.hpp"
#include "api/surface_picture.hpp"
#include "batten/base/error.hpp"
#include "batten/measure/arc_length_map.hpp"

namespace batten::api {
namespace {

constexpr std::size_t tones = 6;  // that curves take in turn, from ink to violet

struct DrawOptions {
    bool comb = false;
    bool control_polygon = false;
    bool curvature = false;
    bool index = false;
    std::optional<int> samples;
    bool lcg = false;
    std::optional<int> contours;
    bool surface = false;
    std::string title;
    int width = 800;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, DrawOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("comb", o.comb, anything, "the curvature comb of each curve");
    visit("control_polygon", o.control_polygon, anything, "the Bezier control points of each curve");
    visit("curvature", o.curvature, anything, "a second panel: curvature against arc length");
    visit("index", o.index, anything, "number the points, from 0");
    visit("samples", o.samples, between(2, 1e5),
          "so many marks on each curve, equally far apart along it");
    visit("lcg", o.lcg, anything,
          "a panel more: the logarithmic curvature graph, its line and slope; in space that of "
          "torsion as well");
    visit("contours", o.contours, between(1, 1000),
          "of surfaces: lines of equal height at so many round levels, or up to 2.5 times as "
          "many [10]");
    visit("surface", o.surface, anything, "of surfaces: a panel more, the surface in space");
    visit("title", o.title, anything, "a line of text above the picture");
    visit("width", o.width, between(240, 4000), "width of the picture in pixels");
}

struct DrawReport {
    std::size_t curves = 0;
    std::size_t points = 0;
    std::size_t surfaces = 0;
    std::vector<std::string> notes;
};

template <class Visit>
void visit_fields(const DrawReport& r, Visit&& visit) {
    visit("curves", r.curves, "curves in the picture");
    visit("points", r.points, "points in the picture");
    visit("surfaces", r.surfaces, "surfaces in the picture");
    visit("notes", r.notes, "what else there is to say");
}

/// Parameters of `count` points equally far apart along `curve`, its ends among them.
std::vector<double> equal_marks(const Curve& curve, int count) {
    const ArcLengthMap map(curve);
    std::vector<double> t;
    for (int i = 0; i + 1 < count; ++i) t.push_back(map.t_of(map.length() * i / (count - 1)));
    t.push_back(curve.domain().hi);
    return t;
}

void add_curve(Drawing& drawing, const Curve& curve, const std::string& name, Tone tone,
               const DrawOptions& options) {
    const std::vector<Curve> parts = parts_between_jumps(curve);
    for (const Curve& part : parts) {
        if (options.comb) drawing.add(CombLayer{part, {}});
        if (options.control_polygon) drawing.add(ControlPolygonLayer{part, {}});
    }
    add_parts(drawing, curve, name, tone);
    for (const Curve& part : parts) {
        if (options.samples) drawing.add(TicksLayer{part, equal_marks(part, *options.samples), {}});
    }
}

/// A curve of constant curvature has no point in the graph.
void add_graph(std::vector<Panel>& plots, const Curve& curve, const std::string& name,
               DrawReport& report) {
    Panel plot = curvature_graph_plot(curve, name);
    const auto* dots = std::get_if<PointsLayer>(&plot.layers.front());
    if (dots && dots->points.empty()) {
        report.notes.push_back("no logarithmic curvature graph: the curvature is constant" +
                               (name.empty() ? "" : ": " + name));
        return;
    }
    plots.push_back(std::move(plot));
}

/// Whether all curves are graphs y(x), whose axes have units of their own. A comb stands upright on
/// its curve only where they have one.
bool shows_functions(std::span<const Input> inputs, const DrawOptions& options) {
    bool has_curve = false;
    for (const Input& input : inputs) {
        const Curve* curve = std::get_if<Curve>(&input.content);
        if (curve && !function_of(*curve)) return false;
        has_curve = has_curve || curve;
    }
    return has_curve && !options.comb;
}

/// The points of a table; beside graphs those that a fit of y(x) would take.
SharedPoints points_shown(const PointsInput& table, bool are_functions) {
    const bool has_choice = are_functions && !table.borrowed && table.columns.size() > 2;
    if (!has_choice) return points_of(table);
    const auto [x, y] = function_columns(table.table, {});
    return points_of({table.table, {x, y}});
}

/// A chart whose axes are called as in the first table with names.
void make_chart(Panel& panel, std::span<const Input> inputs) {
    AxisNames names;
    for (const Input& input : inputs) {
        const auto* table = std::get_if<PointsInput>(&input.content);
        if (!table || table->table.names.empty()) continue;
        const auto [x, y] = table->columns.size() == 2
                                ? std::array{table->columns[0], table->columns[1]}
                                : function_columns(table->table, {});
        const auto name = [&](int column) {
            return table->table.names[static_cast<std::size_t>(column)];
        };
        names = {name(x), name(y)};
        break;
    }
    panel.kind = PanelKind::chart;
    panel.x_label = names.x;
    panel.y_label = names.y;
}

/// Plots along a curve need one without jumps.
void require_whole(const Curve& curve, const std::string& name, const DrawOptions& options) {
    if (!has_jumps(curve) || (!options.curvature && !options.lcg)) return;
    throw Error("curve.jumps", name, "curvature or lcg", "these are drawn of curves without jumps");
}

template <class Content>
bool has_a(std::span<const Input> inputs) {
    return std::any_of(inputs.begin(), inputs.end(), [](const Input& input) {
        return std::holds_alternative<Content>(input.content);
    });
}

/// Throws `option.unused` where an option is asked for that nothing in the picture has.
void require_used(std::span<const Input> inputs, const DrawOptions& o) {
    const auto require = [](bool is_asked, bool is_there, const char* option, const char* rule) {
        if (is_asked && !is_there) throw Error("option.unused", option, "given", rule);
    };
    const bool has_curve = has_a<Curve>(inputs), has_surface = has_a<Surface>(inputs);
    const char* const of_curves = "is drawn of curves, and there is none";
    require(o.comb, has_curve, "comb", of_curves);
    require(o.control_polygon, has_curve, "control_polygon", of_curves);
    require(o.curvature, has_curve, "curvature", of_curves);
    require(o.samples.has_value(), has_curve, "samples", of_curves);
    require(o.lcg, has_curve, "lcg", of_curves);
    require(o.index, has_a<PointsInput>(inputs), "index", "numbers points, and there are none");
    const char* const of_surfaces = "is drawn of surfaces, and there is none";
    require(o.contours.has_value(), has_surface, "contours", of_surfaces);
    require(o.surface, has_surface, "surface", of_surfaces);
}

Outcome run(std::span<const Input> inputs, const DrawOptions& options) {
    require_used(inputs, options);
    Drawing drawing;
    drawing.title = options.title;
    drawing.width = options.width;
    std::vector<Panel> plots;
    DrawReport report;
    const bool are_functions = shows_functions(inputs, options);
    if (are_functions) make_chart(drawing.panels.front(), inputs);
    const auto legend = [&](const Input& input) { return inputs.size() > 1 ? input.name : ""; };
    for (const Input& input : inputs) {
        if (const Curve* curve = std::get_if<Curve>(&input.content)) {
            require_whole(*curve, input.name, options);
            const Tone tone = static_cast<Tone>(report.curves % tones);
            add_curve(drawing, *curve, legend(input), tone, options);
            if (options.curvature) plots.push_back(curvature_plot(*curve, legend(input)));
            if (options.lcg) add_graph(plots, *curve, legend(input), report);
            if (options.lcg && curve->dim() == 3) {
                plots.push_back(torsion_graph_plot(*curve, legend(input)));
            }
            ++report.curves;
        }
    }
    for (const Input& input : inputs) {
        if (const auto* surface = std::get_if<Surface>(&input.content)) {
            const int levels = options.contours.value_or(usual_levels);
            plots.push_back(surface_map(*surface, levels));
            if (options.surface) plots.push_back(surface_relief(*surface, levels));
            ++report.surfaces;
        }
    }
    for (const Input& input : inputs) {
        if (const auto* table = std::get_if<PointsInput>(&input.content)) {
            const SharedPoints points = points_shown(*table, are_functions);
            report.points += points.size();
            drawing.add(PointsLayer{Points(points), legend(input), Marker::open, {},
                                    options.index ? PointLabels::index : PointLabels::none});
        }
    }
    if (report.curves + report.points == 0 && report.surfaces > 0) drawing.panels.clear();
    for (Panel& plot : plots) drawing.panels.push_back(std::move(plot));
    return {drawing, Status::met, {}, report_value(report), [drawing] { return drawing; }};
}

}  // namespace

Operation draw_row() {
    return row<DrawOptions>({"draw", "a picture of points, curves and surfaces", InputKind::any,
                             OutputKind::drawing, {}, true, true},
                            run);
}

}  // namespace batten::api
