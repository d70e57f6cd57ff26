#include "batten/io/draw/gnuplot.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "io/draw/layers/color_bar.hpp"
#include "io/draw/layers/map.hpp"
#include "io/draw/prepare.hpp"
#include "io/draw/scene/ramp.hpp"
#include "io/draw/scene/theme.hpp"

namespace batten {
namespace {

using namespace drawing;

constexpr int chords_a_bezier = 16;
constexpr std::size_t most_cells = 120;  ///< of a map, in each direction

/// In gnuplot's double quotes; only names and captions of people come here.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\' || c == '`' || c == '$') result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result + '"';
}

std::string rows_of(const Points& run) {
    std::string rows;
    for (std::size_t i = 0; i < run.size(); ++i) {
        for (int k = 0; k < run.dim(); ++k) {
            rows += format_number(run(i, k)) + (k + 1 < run.dim() ? ' ' : '\n');
        }
    }
    return rows + '\n';
}

/// A trace as chains of chords.
std::string rows_of(const Trace& trace) {
    std::string rows;
    for (std::size_t i = 0; i < trace.beziers.size(); i += 4) {
        const int dim = trace.beziers.dim();
        Points run(0, dim);
        for (int k = 0; k <= chords_a_bezier; ++k) {
            const double t = k / double{chords_a_bezier}, s = 1 - t;
            const double w[] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
            double at[3] = {0, 0, 0};
            for (std::size_t j = 0; j < 4; ++j) {
                for (int c = 0; c < dim; ++c) at[c] += w[j] * trace.beziers(i + j, c);
            }
            run.push_back(std::span(at, static_cast<std::size_t>(dim)));
        }
        rows += rows_of(run);
    }
    for (const Points& run : trace.runs) rows += rows_of(run);
    return rows;
}

std::string line_style(const LineStyle& line, Tone tone) {
    const int dash = line.dash == Dash::solid ? 1 : line.dash == Dash::dashed ? 2 : 3;
    return "with lines lw " + format_number(line.width) + " dt " + std::to_string(dash) +
           " lc rgb \"" + std::string(color_of(tone)) + '"';
}

/// One layer as data and how they are plotted.
struct Plot {
    std::string rows;
    std::string style;
};

struct Plotter {
    const ReadyLayer& ready;
    std::string place;

    std::string color() const { return "lc rgb \"" + std::string(color_of(ready.tone)) + '"'; }

    [[noreturn]] Plot refuse(const char* what) const {
        throw Error("drawing.gnuplot", place, what, "is drawn as SVG only");
    }
    Plot operator()(const CurveLayer& layer) const {
        return {rows_of(ready.trace), line_style(layer.line, ready.tone)};
    }
    Plot operator()(const PolylineLayer& layer) const {
        std::string rows;
        for (const Points& run : layer.runs) rows += rows_of(run);
        return {rows, line_style(layer.line, ready.tone)};
    }
    Plot operator()(const PointsLayer& layer) const {
        const char* const sign = layer.marker == Marker::open ? "6" : "7";
        return {rows_of(layer.points), std::string("with points pt ") + sign + " ps 0.5 " + color()};
    }
    Plot operator()(const RegionsLayer& layer) const {
        std::string rows;
        for (const Points& outline : layer.outlines) rows += rows_of(outline);
        return {rows, "with filledcurves closed fs transparent solid 0.2 noborder " + color()};
    }
    Plot operator()(const TicksLayer& layer) const {
        Points points(0, 2);
        for (const double t : layer.at) {
            const Spot at = spot_on(layer.curve, t);
            points.push_back(std::span(at.data(), 2));
        }
        return {rows_of(points), "with points pt 1 ps 0.7 " + color()};
    }
    Plot operator()(const TextLayer& layer) const {
        return {format_number(layer.at[0]) + ' ' + format_number(layer.at[1]) + ' ' +
                    quoted(layer.text) + "\n\n",
                "using 1:2:3 with labels left offset 0.5,0.5 " + std::string("tc rgb \"") +
                    std::string(color_of(ready.tone)) + '"'};
    }
    Plot operator()(const MapLayer& layer) const {
        std::string rows;
        for (const MapCell& cell : cells_of(layer, most_cells, most_cells)) {
            const double x = 0.5 * cell.x.lo + 0.5 * cell.x.hi;
            const double y = 0.5 * cell.y.lo + 0.5 * cell.y.hi;
            for (const double number : {x, y, cell.x.lo, cell.x.hi, cell.y.lo, cell.y.hi}) {
                rows += format_number(number) + ' ';
            }
            rows += format_number(cell.value) + '\n';
        }
        return {rows + '\n', "using 1:2:3:4:5:6:7 with boxxyerror fs solid noborder lc palette"};
    }
    Plot operator()(const ColoredPointsLayer& layer) const {
        std::string rows;
        for (std::size_t i = 0; i < layer.points.size(); ++i) {
            rows += format_number(layer.points(i, 0)) + ' ' + format_number(layer.points(i, 1)) +
                    ' ' + format_number(layer.values[i]) + '\n';
        }
        // Once larger in grey, which leaves a rim: those around 0 are nearly paper.
        return {rows + '\n', "using 1:2 with points pt 7 ps 0.75 lc rgb \"" +
                                 std::string(axis_color) + "\" notitle, '' " +
                                 "using 1:2:3 with points pt 7 ps 0.6 lc palette"};
    }
    Plot operator()(const SheetLayer& layer) const {
        const Grid& nodes = layer.nodes;
        std::string rows;
        for (std::size_t i = 0; i < nodes.nu(); ++i) {
            for (std::size_t j = 0; j < nodes.nv(); ++j) {
                for (int k = 0; k < 3; ++k) {
                    rows += (nodes.has(i, j) ? format_number(nodes(i, j, k)) : "NaN") + ' ';
                }
                rows += '\n';
            }
            rows += '\n';
        }
        if (layer.style == SheetStyle::wire) return {rows + '\n', "with lines lw 0.6 " + color()};
        const std::string fill = "fc rgb \"" + std::string(shade_color(layer.tone, shade_classes / 2)) + '"';
        return {rows + '\n', "with pm3d " + fill};
    }
    Plot operator()(const ControlPolygonLayer&) const { return refuse("a control polygon"); }
    Plot operator()(const CombLayer&) const { return refuse("a comb"); }
    Plot operator()(const ArrowsLayer&) const { return refuse("arrows"); }
};

std::string range_of(const char* axis, Interval side, bool is_log) {
    const double lo = is_log ? std::pow(10.0, side.lo) : side.lo;
    const double hi = is_log ? std::pow(10.0, side.hi) : side.hi;
    std::string text = is_log ? std::string("set logscale ") + axis : std::string("unset logscale ") + axis;
    text += std::string("\nset ") + axis + "range [";
    if (lo < hi) text += format_number(lo) + ':' + format_number(hi);
    return text + "]\n";
}

/// The colours of a map and their bar, or neither.
std::string palette_of(const ReadyPanel& ready) {
    for (const ReadyLayer& layer : ready.layers) {
        const std::optional<ColorBar> bar = drawing::bar_of(*layer.layer);
        if (!bar) continue;
        std::string text = "set palette maxcolors " + std::to_string(ramp_classes) + " defined (";
        for (int k = 0; k < ramp_classes; ++k) {
            text += (k > 0 ? ", " : "") + std::to_string(k) + " \"" +
                    std::string(ramp_color(bar->ramp, k)) + '"';
        }
        return text + ")\nset cbrange [" + format_number(bar->range.lo) + ':' +
               format_number(bar->range.hi) + "]\nset cblabel " + quoted(bar->name) +
               "\nset colorbox\n";
    }
    return "unset colorbox\n";
}

bool can_splot(const Layer& layer) {
    return std::holds_alternative<CurveLayer>(layer) ||
           std::holds_alternative<PolylineLayer>(layer) ||
           std::holds_alternative<PointsLayer>(layer) || std::holds_alternative<SheetLayer>(layer);
}

/// The axes of a panel in space, seen from where `svg` sees it.
std::string space_axes(const Panel& panel) {
    return "unset colorbox\nunset label\nset zlabel " + quoted(panel.z_label) +
           "\nset view 55,45\nset xyplane 0\nset pm3d depthorder lighting\nset hidden3d\n" +
           (panel.kind == PanelKind::geometry ? "set view equal xyz\n" : "set view noequal\n");
}

/// What is written upon lines in the plane, each somewhere else along its line: lines around one
/// hill would have their middles beside one another.
std::string labels_of(const ReadyPanel& ready) {
    constexpr double golden = 0.381966;
    std::string text = "unset label\n";
    double share = 0.5;
    const auto write = [&](double x, double y, const std::string& label) {
        text += "set label " + quoted(label) + " at " + format_number(x) + ',' + format_number(y) +
                " center front font \",9\"\n";
        share = std::fmod(share + golden, 1);
    };
    for (const ReadyLayer& layer : ready.layers) {
        if (const auto* curve = std::get_if<CurveLayer>(layer.layer)) {
            if (curve->label.empty()) continue;
            const Interval domain = curve->curve.domain();
            const Spot at = spot_on(curve->curve, domain.lo + share * domain.length());
            write(at[0], at[1], curve->label);
        }
        if (const auto* lines = std::get_if<PolylineLayer>(layer.layer)) {
            if (lines->label.empty() || lines->runs.empty()) continue;
            const Points& run = lines->runs.front();
            const std::size_t at = static_cast<std::size_t>(share * static_cast<double>(run.size()));
            write(run(at, 0), run(at, 1), lines->label);
        }
    }
    return text;
}

std::string panel_script(const ReadyPanel& ready, std::size_t index, std::set<std::string>& named) {
    const Panel& panel = *ready.panel;
    const std::string place = "panel " + std::to_string(index);
    std::string text = "set title " + quoted(panel.caption) + " tc rgb \"" +
                       std::string(ink_color) + "\"\nset xlabel " +
                       quoted(panel.x_label) + "\nset ylabel " + quoted(panel.y_label) + '\n';
    const bool is_space = ready.box.dim == 3;
    text += range_of("x", ready.box.sides[0], ready.is_log[0]);
    text += range_of("y", ready.box.sides[1], ready.is_log[1]);
    text += !is_space && panel.kind == PanelKind::geometry ? "set size ratio -1\n"
                                                          : "set size noratio\n";
    text += is_space ? space_axes(panel) : palette_of(ready) + labels_of(ready);
    std::string plots;
    for (std::size_t i = 0; i < ready.layers.size(); ++i) {
        const ReadyLayer& layer = ready.layers[i];
        if (is_space && !can_splot(*layer.layer)) {
            throw Error("drawing.gnuplot", place, "a layer in space",
                        "only curves, lines, points and sheets are drawn there");
        }
        const Plot plot = std::visit(Plotter{layer, place + " layer " + std::to_string(i)},
                                     *layer.layer);
        if (plot.rows.empty()) continue;
        const std::string block = "$d" + std::to_string(index) + '_' + std::to_string(i);
        text += block + " << END_OF_DATA\n" + plot.rows + "END_OF_DATA\n";
        const std::string& name = name_of(*layer.layer);
        const bool is_new = !name.empty() && named.insert(name).second;
        plots += (!plots.empty() ? ", \\\n     " : is_space ? "splot " : "plot ") + block + ' ' + plot.style +
                 (is_new ? " title " + quoted(name) : " notitle");
    }
    return text + (plots.empty() ? "plot NaN notitle" : plots) + '\n';
}

std::string terminal(const Drawing& drawing, ChartFormat format, std::size_t rows) {
    const std::size_t height = 90 + 400 * rows;
    switch (format) {
        case ChartFormat::svg:
            return "svg noenhanced size " + std::to_string(drawing.width) + ',' +
                   std::to_string(height);
        case ChartFormat::png:
            return "pngcairo noenhanced size " + std::to_string(drawing.width) + ',' +
                   std::to_string(height);
        case ChartFormat::pdf: break;
    }
    return "pdfcairo noenhanced size " + format_fixed(drawing.width / 100.0, 2) + ',' +
           format_fixed(static_cast<double>(height) / 100.0, 2);
}

}  // namespace

std::string gnuplot_script(const Drawing& drawing, ChartFormat format) {
    const std::vector<ReadyPanel> panels = prepare(drawing);
    const std::size_t usual = panels.size() == 4 ? 2 : 3;
    const std::size_t columns = std::min(
        panels.size(), drawing.columns ? static_cast<std::size_t>(*drawing.columns) : usual);
    const std::size_t rows = (panels.size() + columns - 1) / columns;
    std::string text = "set encoding utf8\nset terminal " + terminal(drawing, format, rows) +
                       "\nset border 3 lc rgb \"" + std::string(axis_color) +
                       "\"\nset tics nomirror tc rgb \"" + std::string(text_color) +
                       "\"\nset grid lc rgb \"" + std::string(grid_color) +
                       "\" lt 1\nset key tmargin right horizontal samplen 2\n";
    std::string title = drawing.title;
    if (!drawing.subtitle.empty()) title += (title.empty() ? "" : " — ") + drawing.subtitle;
    text += "set multiplot layout " + std::to_string(rows) + ',' + std::to_string(columns) +
            " title " + quoted(title) + '\n';
    std::set<std::string> named;
    for (std::size_t i = 0; i < panels.size(); ++i) text += panel_script(panels[i], i, named);
    return text + "unset multiplot\n";
}

}  // namespace batten
