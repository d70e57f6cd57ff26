#include "api/surface_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "api/picture_text.hpp"
#include "batten/base/text.hpp"

namespace batten::api {
namespace {

constexpr std::size_t relief_nodes = 37;
constexpr std::size_t front_relief_nodes = 61;
constexpr std::size_t level_nodes = 161;  // of surfaces of steps, whose lines are not traced
constexpr int picture_width = 960;

/// Residuals in standard deviations: those of the file, else `sigma`.
Heights scaled_residuals(const Surface& surface, const GridFile& grid, double sigma) {
    Heights e{grid.x, grid.y, grid.z};
    const Grid s = heights_on(surface, grid.x, grid.y);
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
        for (std::size_t j = 0; j < grid.y.size(); ++j) {
            if (!grid.z.has(i, j)) continue;
            const bool has_own = !grid.sigma.empty();
            const double unit = has_own ? grid.sigma[i * grid.y.size() + j] : sigma;
            e.z(i, j) = (grid.z(i, j) - s(i, j)) / unit;
        }
    }
    return e;
}

/// The surface as its relief shows it: denser where a front would look like a saw.
Heights seen(const Surface& surface) {
    const bool is_curved = std::holds_alternative<CurvedKnotSurface>(surface);
    return sampled(surface, is_curved ? front_relief_nodes : relief_nodes);
}

std::vector<double> levels_in(const Heights& heights, int count) {
    const std::span<const double> z = heights.z.view().values();
    const auto [lo, hi] = std::minmax_element(z.begin(), z.end());
    return round_levels(Interval{*lo, *hi}, count);
}

bool has_level_lines(const Surface& surface) {
    if (const auto* curved = std::get_if<CurvedKnotSurface>(&surface)) return curved->degree() > 0;
    const SplineSurface& product = std::get<SplineSurface>(surface);
    return std::min(product.x_basis().degree(), product.y_basis().degree()) > 0;
}

/// The lines; of a surface that has none its heights, which are one.
Panel levels_of(const Surface& surface, const std::vector<double>& levels) {
    const std::string caption = "lines of equal height";
    Panel panel = has_level_lines(surface)
                      ? level_plot(surface, levels, caption)
                      : level_plot(sampled(surface, level_nodes), levels, caption);
    if (!panel.layers.empty()) return panel;
    const Heights heights = seen(surface);
    return height_map(heights, "one height: " + format_brief(heights.z(0, 0), 4));
}

Panel relief_of(const Surface& surface, const Heights& heights, const std::vector<double>& levels) {
    constexpr const char* caption = "the surface";
    if (const auto* curved = std::get_if<CurvedKnotSurface>(&surface)) {
        return relief_plot(*curved, levels, caption);
    }
    return relief_plot(heights, {levels, front_relief_nodes}, caption);
}

std::string sizes(std::size_t samples, std::size_t missing, const std::array<int, 2>& strips,
                  int parameters) {
    std::string text = counted(samples, "sample", "samples");
    if (missing > 0) text += " and " + std::to_string(missing) + " missing";
    return text + ", " + std::to_string(strips[0]) + " × " + std::to_string(strips[1]) +
           " strips, " +
           counted(static_cast<std::size_t>(parameters), "coefficient", "coefficients");
}

std::string sizes(const GridFile& grid, const std::array<int, 2>& strips, int parameters) {
    const std::size_t missing = grid.z.missing();
    return sizes(grid.z.nu() * grid.z.nv() - missing, missing, strips, parameters);
}

std::string misfit(double delta2, std::optional<double> sigma2) {
    std::string text = ", δ² = " + format_fixed(delta2, 2);
    if (sigma2) text += ", σ² = " + format_fixed(*sigma2, 3);
    return text;
}

Drawing fit_panels(const Surface& surface, const GridFile& grid, double sigma) {
    const std::vector<PolylineLayer> knots = knot_lines(surface);
    const Heights heights = seen(surface);
    const std::vector<double> levels = levels_in(heights, usual_levels);
    Panel data = height_map({grid.x, grid.y, grid.z}, "data and knot lines");
    for (const PolylineLayer& lines : knots) data.add(lines);
    Drawing drawing;
    drawing.width = picture_width;
    drawing.columns = 2;
    drawing.panels = {std::move(data), levels_of(surface, levels),
                      residual_map(scaled_residuals(surface, grid, sigma), knots, "residuals"),
                      relief_of(surface, heights, levels)};
    return drawing;
}

}  // namespace

Panel surface_map(const Surface& surface, int levels) {
    Panel map = levels_of(surface, levels_in(seen(surface), levels));
    for (const PolylineLayer& lines : knot_lines(surface)) map.add(lines);
    return map;
}

Panel surface_relief(const Surface& surface, int levels) {
    const Heights heights = seen(surface);
    return relief_of(surface, heights, levels_in(heights, levels));
}

Drawing surface_picture(const Surface& surface, int levels) {
    Drawing drawing;
    drawing.width = picture_width;
    drawing.panels = {surface_map(surface, levels), surface_relief(surface, levels)};
    return drawing;
}

Drawing contour_map(const Rectangle& domain, const std::vector<Contour>& lines) {
    Drawing drawing;
    drawing.panels = {map_panel(domain, {})};
    add_levels(drawing.panels.front(), lines);
    return drawing;
}

Drawing contour_picture(const Surface& surface, const std::vector<Contour>& lines) {
    std::vector<double> levels;
    for (const Contour& line : lines) {
        if (levels.empty() || levels.back() != line.level) levels.push_back(line.level);
    }
    Drawing drawing;
    drawing.width = picture_width;
    drawing.panels = {relief_of(surface, seen(surface), levels)};
    if (lines.empty()) return drawing;
    Panel map = contour_map(domain_of(surface), lines).panels.front();
    map.caption = "lines of equal height";
    drawing.panels.insert(drawing.panels.begin(), std::move(map));
    return drawing;
}

Drawing surface_fit_picture(const SurfaceFit& fit, const GridFile& grid) {
    const FitSurfaceReport& report = fit.report;
    Drawing drawing = fit_panels(fit.surface, grid, report.sigma.value_or(1));
    drawing.title = "Least-squares spline surface";
    drawing.subtitle = sizes(grid, report.intervals, report.parameters) +
                       misfit(report.delta2, report.sigma2);
    if (report.chi2_p) drawing.subtitle += ", χ² p " + probability_text(*report.chi2_p);
    if (report.sigma_source == SigmaSource::estimated) drawing.subtitle += ", σ estimated";
    return drawing;
}

Drawing scattered_fit_picture(const SurfaceFit& fit, const ScatteredSamples& samples) {
    const Surface surface(fit.surface);
    const auto copy = [](std::span<const double> from) {
        return std::vector<double>(from.begin(), from.end());
    };
    const PlacedNumbers heights{copy(samples.x), copy(samples.y), copy(samples.z)};
    PlacedNumbers residuals = heights;
    // Where nothing is left there is no error to go by.
    const double common = fit.report.sigma.value_or(1) > 0 ? fit.report.sigma.value_or(1) : 1;
    for (std::size_t i = 0; i < heights.values.size(); ++i) {
        const double unit = samples.sigma.empty() ? common : samples.sigma[i];
        residuals.values[i] = (samples.z[i] - fit.surface(samples.x[i], samples.y[i])) / unit;
    }
    const std::vector<PolylineLayer> knots = knot_lines(surface);
    const Rectangle domain = fit.surface.domain();
    const Heights relief = seen(surface);
    const std::vector<double> levels = levels_in(relief, usual_levels);
    Drawing drawing;
    drawing.title = "Least-squares spline surface through scattered points";
    drawing.subtitle = sizes(samples.x.size(), 0, fit.report.intervals, fit.report.parameters) +
                       misfit(fit.report.delta2, fit.report.sigma2);
    drawing.width = picture_width;
    drawing.columns = 2;
    drawing.panels = {height_dots(heights, knots, domain, "data and knot lines"),
                      levels_of(surface, levels),
                      residual_dots(residuals, knots, domain, "residuals"),
                      relief_of(surface, relief, levels)};
    return drawing;
}

Drawing curved_fit_picture(const CurvedKnotSurface& surface, const FrontReport& report,
                           const GridFile& grid, double sigma) {
    Drawing drawing = fit_panels(surface, grid, sigma);
    drawing.title = "Least-squares spline surface with curved knot lines";
    drawing.subtitle = sizes(grid, report.intervals, report.parameters) +
                       misfit(report.delta2, report.sigma2);
    return drawing;
}

}  // namespace batten::api
