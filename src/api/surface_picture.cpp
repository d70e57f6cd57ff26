#include "api/surface_picture.hpp"

#include <cmath>
#include <functional>

#include "batten/base/text.hpp"

namespace batten::api {
namespace {

constexpr double notable = 2;  // standard deviations

Points segment(double x0, double y0, double x1, double y1) {
    return {std::vector<double>{x0, y0, x1, y1}, 2};
}

void add_knot_lines(Panel& panel, const SplineSurface& surface) {
    const Rectangle domain = surface.domain();
    PolylineLayer lines{{}, "knot lines", {Tone::grey, Dash::dotted, 0.8}};
    for (const double x : surface.x_basis().breaks()) {
        lines.runs.push_back(segment(x, domain.y.lo, x, domain.y.hi));
    }
    for (const double y : surface.y_basis().breaks()) {
        lines.runs.push_back(segment(domain.x.lo, y, domain.x.hi, y));
    }
    panel.add(lines);
}

/// The root mean square residual is one standard deviation where no errors are known.
double sigma_at(const SurfaceFit& fit, const GridFile& grid, std::size_t node) {
    if (!grid.sigma.empty()) return grid.sigma[node];
    return fit.report.sigma.value_or(1);
}

void add_residuals(Panel& panel, const SurfaceFit& fit, const GridFile& grid) {
    const Grid s = fit.surface.evaluate(grid.x, grid.y);
    Points above(0, 2), below(0, 2);
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
        for (std::size_t j = 0; j < grid.y.size(); ++j) {
            if (!grid.z.has(i, j)) continue;
            const double e = grid.z(i, j) - s(i, j);
            const double sigma = sigma_at(fit, grid, i * grid.y.size() + j);
            const double place[] = {grid.x[i], grid.y[j]};
            if (e > notable * sigma) above.push_back(place);
            if (e < -notable * sigma) below.push_back(place);
        }
    }
    if (!above.empty()) {
        panel.add(PointsLayer{above, "data above by 2 sigma", Marker::closed, {},
                              PointLabels::none, Tone::accent});
    }
    if (!below.empty()) {
        panel.add(PointsLayer{below, "data below by 2 sigma", Marker::open, {}, PointLabels::none,
                              Tone::blue});
    }
}

Panel map_panel(const std::string& caption) {
    Panel panel;
    panel.caption = caption;
    panel.kind = PanelKind::chart;
    panel.x_label = "x";
    panel.y_label = "y";
    return panel;
}

/// The knot lines, curved and straight.
Panel front_map(const CurvedKnotSurface& surface) {
    constexpr std::size_t places = 101;
    const Rectangle domain = surface.domain();
    Panel panel = map_panel("knot lines");
    PolylineLayer curved{{}, "lines of x", {Tone::accent}};
    for (const SplineFunction& line : surface.x_lines()) {
        Points run(0, 2);
        for (const double y : even_places(domain.y, places)) {
            run.push_back(std::vector<double>{line(y), y});
        }
        curved.runs.push_back(std::move(run));
    }
    PolylineLayer across{{}, "lines of y", {Tone::grey, Dash::dotted, 0.8}};
    for (const SplineFunction& line : surface.y_lines()) {
        Points run(0, 2);
        for (const double x : even_places(domain.x, places)) {
            run.push_back(std::vector<double>{x, line(x)});
        }
        across.runs.push_back(std::move(run));
    }
    for (PolylineLayer& layer : {std::ref(curved), std::ref(across)}) {
        if (!layer.runs.empty()) panel.add(layer);
    }
    panel.x_range = domain.x;
    panel.y_range = domain.y;
    return panel;
}

}  // namespace

void add_contours(Panel& panel, const std::vector<Contour>& lines) {
    for (const Contour& line : lines) panel.add(CurveLayer{line.curve, {}, {Tone::blue}});
    double labelled = std::nan("");
    for (const Contour& line : lines) {
        if (line.level == labelled) continue;
        labelled = line.level;
        panel.add(TextLayer{line.curve(line.curve.domain().middle()), format_number(line.level),
                            Tone::ink});
    }
}

Panel surface_map(const Surface& surface, int levels) {
    if (const auto* curved = std::get_if<CurvedKnotSurface>(&surface)) return front_map(*curved);
    const SplineSurface& product = std::get<SplineSurface>(surface);
    Panel map = map_panel("lines of equal height");
    add_knot_lines(map, product);
    for (const double level : round_levels(product, levels)) {
        add_contours(map, contours(product, level, relative(1e-4)));
    }
    return map;
}

Drawing surface_picture(const Surface& surface, int levels) {
    Drawing drawing;
    drawing.panels = {surface_map(surface, levels)};
    return drawing;
}

Drawing surface_fit_picture(const SurfaceFit& fit, const GridFile& grid) {
    Drawing drawing = surface_picture(Surface(fit.surface), usual_levels);
    Panel rest = map_panel("residuals");
    add_knot_lines(rest, fit.surface);
    add_residuals(rest, fit, grid);
    drawing.panels.push_back(std::move(rest));
    return drawing;
}

}  // namespace batten::api
