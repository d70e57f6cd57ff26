#include "batten/io/draw/surface_plots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "batten/measure/level_lines.hpp"
#include "io/draw/axes/ticks.hpp"

namespace batten {
namespace {

constexpr double most_unequal = 2.5;
constexpr std::size_t most_numbered = 12;  ///< levels; of more only every other one is
constexpr std::size_t curved_line_places = 101;
constexpr LineStyle level_style{Tone::blue, Dash::solid, 1.1};
constexpr LineStyle relief_level_style{Tone::ink, Dash::solid, 0.7};
constexpr LineStyle knot_style{Tone::ink, Dash::dotted, 1};

Rectangle part_of(const Heights& heights) {
    return {{heights.x.front(), heights.x.back()}, {heights.y.front(), heights.y.back()}};
}

Points straight_line(double x0, double y0, double x1, double y1) {
    return {std::vector<double>{x0, y0, x1, y1}, 2};
}

std::vector<PolylineLayer> straight_knots(const SplineSurface& surface) {
    const Rectangle domain = surface.domain();
    PolylineLayer lines{{}, "knot lines", knot_style};
    for (const double x : surface.x_basis().breaks()) {
        lines.runs.push_back(straight_line(x, domain.y.lo, x, domain.y.hi));
    }
    for (const double y : surface.y_basis().breaks()) {
        lines.runs.push_back(straight_line(domain.x.lo, y, domain.x.hi, y));
    }
    return {lines};
}

std::vector<PolylineLayer> curved_knots(const CurvedKnotSurface& surface) {
    const Rectangle& domain = surface.domain();
    PolylineLayer straight{{}, "knot lines", knot_style};
    PolylineLayer curved{{}, "curved knot lines", {Tone::accent, Dash::solid, 0.9}};
    const auto add = [&](const SplineFunction& line, bool is_in_x) {
        Points run(0, 2);
        for (const double t : even_places(is_in_x ? domain.y : domain.x, curved_line_places)) {
            run.push_back(is_in_x ? std::array{line(t), t} : std::array{t, line(t)});
        }
        (are_straight({&line, 1}) ? straight : curved).runs.push_back(std::move(run));
    };
    for (const SplineFunction& line : surface.x_lines()) add(line, true);
    for (const SplineFunction& line : surface.y_lines()) add(line, false);
    std::vector<PolylineLayer> layers;
    for (PolylineLayer& layer : std::array{straight, curved}) {
        if (!layer.runs.empty()) layers.push_back(std::move(layer));
    }
    return layers;
}

/// Evenly picked numbers below `count`, both ends among them.
std::vector<std::size_t> picked(std::size_t count, std::size_t most_nodes) {
    const std::size_t most = std::min(count, std::max<std::size_t>(most_nodes, 2));
    std::vector<std::size_t> nodes;
    for (std::size_t k = 0; k < most; ++k) nodes.push_back(k * (count - 1) / (most - 1));
    return nodes;
}

Heights thinned(const Heights& heights, std::size_t most) {
    const std::vector<std::size_t> rows = picked(heights.x.size(), most);
    const std::vector<std::size_t> columns = picked(heights.y.size(), most);
    Heights result{{}, {}, Grid(rows.size(), columns.size())};
    for (const std::size_t i : rows) result.x.push_back(heights.x[i]);
    for (const std::size_t j : columns) result.y.push_back(heights.y[j]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t j = 0; j < columns.size(); ++j) {
            if (heights.z.has(rows[i], columns[j])) result.z(i, j) = heights.z(rows[i], columns[j]);
            else result.z.drop(i, j);
        }
    }
    return result;
}

/// A place among rising `places` in counts of them.
double count_at(const std::vector<double>& places, double x) {
    const auto above = std::upper_bound(places.begin() + 1, places.end() - 1, x);
    const std::size_t i = static_cast<std::size_t>(above - places.begin()) - 1;
    const double share = (x - places[i]) / (places[i + 1] - places[i]);
    return static_cast<double>(i) + std::clamp(share, 0.0, 1.0);
}

std::vector<SheetLine> lines_upon(const Heights& heights, const std::vector<double>& levels) {
    std::vector<SheetLine> lines;
    for (const double level : levels) {
        for (const Points& run : level_lines(heights.x, heights.y, heights.z, level)) {
            SheetLine line{Points(0, 2), relief_level_style};
            for (std::size_t i = 0; i < run.size(); ++i) {
                line.places.push_back(std::array{count_at(heights.x, run(i, 0)),
                                                 count_at(heights.y, run(i, 1))});
            }
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

constexpr const char* residual_bar = "residual / σ";

/// Whole standard deviations, two at least.
Interval residual_range(std::span<const double> residuals) {
    double most = 2;
    for (const double e : residuals) most = std::max(most, std::ceil(std::fabs(e)));
    return {-most, most};
}

std::vector<BarMark> sigma_marks() { return {{-1, "−σ"}, {1, "σ"}}; }

Points points_of(const PlacedNumbers& numbers) {
    Points points(0, 2);
    for (std::size_t i = 0; i < numbers.x.size(); ++i) {
        points.push_back(std::array{numbers.x[i], numbers.y[i]});
    }
    return points;
}

}  // namespace

Heights sampled(const Surface& surface, std::size_t count) {
    const Rectangle domain = domain_of(surface);
    Heights heights{even_places(domain.x, count), even_places(domain.y, count), Grid(0, 0)};
    heights.z = heights_on(surface, heights.x, heights.y);
    return heights;
}

std::vector<PolylineLayer> knot_lines(const Surface& surface) {
    if (const auto* spline = std::get_if<SplineSurface>(&surface)) return straight_knots(*spline);
    return curved_knots(std::get<CurvedKnotSurface>(surface));
}

Panel map_panel(const Rectangle& part, std::string caption) {
    const double ratio = part.x.length() / part.y.length();
    Panel panel;
    panel.caption = std::move(caption);
    panel.kind = ratio >= 1 / most_unequal && ratio <= most_unequal ? PanelKind::geometry
                                                                    : PanelKind::chart;
    panel.x_label = "x";
    panel.y_label = "y";
    panel.x_range = part.x;
    panel.y_range = part.y;
    return panel;
}

Panel level_plot(const Heights& heights, const std::vector<double>& levels, std::string caption) {
    Panel panel = map_panel(part_of(heights), std::move(caption));
    const std::size_t step = levels.size() > most_numbered ? 2 : 1;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        std::vector<Points> runs = level_lines(heights.x, heights.y, heights.z, levels[k]);
        if (runs.empty()) continue;
        const std::string label = k % step == 0 ? drawing::short_number(levels[k]) : "";
        panel.add(PolylineLayer{std::move(runs), {}, level_style, label});
    }
    return panel;
}

void add_levels(Panel& panel, const std::vector<Contour>& lines) {
    for (const Contour& line : lines) {
        panel.add(CurveLayer{line.curve, {}, level_style, drawing::short_number(line.level)});
    }
}

Panel level_plot(const Surface& surface, const std::vector<double>& levels,
                 std::string caption) {
    Panel panel = map_panel(domain_of(surface), std::move(caption));
    for (const double level : levels) add_levels(panel, contours(surface, level, relative(1e-4)));
    return panel;
}

Panel relief_plot(const Heights& all, const ReliefStyle& style, std::string caption) {
    const Heights heights = thinned(all, style.most_nodes);
    SheetLayer sheet;
    sheet.style = style.sheet;
    sheet.nodes = Grid(heights.x.size(), heights.y.size(), 3);
    for (std::size_t i = 0; i < heights.x.size(); ++i) {
        for (std::size_t j = 0; j < heights.y.size(); ++j) {
            if (!heights.z.has(i, j)) {
                sheet.nodes.drop(i, j);
                continue;
            }
            sheet.nodes(i, j, 0) = heights.x[i];
            sheet.nodes(i, j, 1) = heights.y[j];
            sheet.nodes(i, j, 2) = heights.z(i, j);
        }
    }
    sheet.lines = lines_upon(heights, style.levels);
    Panel panel;
    panel.caption = std::move(caption);
    panel.kind = PanelKind::relief;
    panel.add(std::move(sheet));
    return panel;
}

Panel height_map(const Heights& heights, std::string caption) {
    Panel panel = map_panel(part_of(heights), std::move(caption));
    panel.add(MapLayer{heights.x, heights.y, heights.z, "z", Ramp::rising, {}, {}});
    return panel;
}

Panel residual_map(const Heights& residuals, const std::vector<PolylineLayer>& knots,
                   std::string caption) {
    Panel panel = map_panel(part_of(residuals), std::move(caption));
    panel.add(MapLayer{residuals.x, residuals.y, residuals.z, residual_bar, Ramp::diverging,
                       residual_range(residuals.z.view().values()), sigma_marks()});
    for (const PolylineLayer& lines : knots) panel.add(lines);
    return panel;
}

Panel height_dots(const PlacedNumbers& heights, const std::vector<PolylineLayer>& knots,
                  const Rectangle& part, std::string caption) {
    Panel panel = map_panel(part, std::move(caption));
    panel.add(ColoredPointsLayer{points_of(heights), heights.values, "z"});
    for (const PolylineLayer& lines : knots) panel.add(lines);
    return panel;
}

Panel residual_dots(const PlacedNumbers& residuals, const std::vector<PolylineLayer>& knots,
                    const Rectangle& part, std::string caption) {
    Panel panel = map_panel(part, std::move(caption));
    panel.add(ColoredPointsLayer{points_of(residuals), residuals.values, residual_bar,
                                 Ramp::diverging, residual_range(residuals.values),
                                 sigma_marks()});
    for (const PolylineLayer& lines : knots) panel.add(lines);
    return panel;
}

}  // namespace batten
