#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "batten/io/draw/surface_plots.hpp"
#include "batten/measure/level_lines.hpp"

/// Reliefs whose nodes follow curved knot lines: a front across a straight net looks fluted.
namespace batten {
namespace {

constexpr std::size_t rows_along = 61;    // nodes along the lines
constexpr std::size_t cells_across = 56;  // shared out by the widths of the strips
constexpr std::size_t least_cells = 2;    // in a strip

/// Where the lines are at `t`, in order and within `across`, both ends added.
std::vector<double> borders(std::span<const SplineFunction> lines, double t, Interval across) {
    std::vector<double> places{across.lo, across.hi};
    for (const SplineFunction& line : lines) places.push_back(across.clamp(line(t)));
    std::sort(places.begin(), places.end());
    return places;
}

/// How many cells each strip gets, by its mean width.
std::vector<std::size_t> cells_of_strips(std::span<const SplineFunction> lines,
                                         const std::vector<double>& along, Interval across) {
    std::vector<double> widths(lines.size() + 1, 0.0);
    for (const double t : along) {
        const std::vector<double> places = borders(lines, t, across);
        for (std::size_t k = 0; k < widths.size(); ++k) widths[k] += places[k + 1] - places[k];
    }
    std::vector<std::size_t> cells;
    const double whole = across.length() * static_cast<double>(along.size());
    for (const double width : widths) {
        const double share = static_cast<double>(cells_across) * width / whole;
        cells.push_back(std::max(least_cells, static_cast<std::size_t>(std::lround(share))));
    }
    return cells;
}

/// The places across at `t`, from strip to strip.
std::vector<double> places_across(std::span<const SplineFunction> lines, double t, Interval across,
                                  const std::vector<std::size_t>& cells) {
    const std::vector<double> ends = borders(lines, t, across);
    std::vector<double> places{ends.front()};
    for (std::size_t k = 0; k < cells.size(); ++k) {
        for (std::size_t i = 1; i <= cells[k]; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(cells[k]);
            places.push_back(std::lerp(ends[k], ends[k + 1], share));
        }
    }
    return places;
}

std::vector<double> counts(std::size_t count) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers.push_back(static_cast<double>(i));
    return numbers;
}

std::vector<SheetLine> level_lines_upon(const Grid& heights, const std::vector<double>& levels) {
    constexpr LineStyle style{Tone::ink, Dash::solid, 0.7};
    const std::vector<double> u = counts(heights.nu()), v = counts(heights.nv());
    std::vector<SheetLine> lines;
    for (const double level : levels) {
        for (Points& run : level_lines(u, v, heights, level)) lines.push_back({std::move(run), style});
    }
    return lines;
}

}  // namespace

Panel relief_plot(const CurvedKnotSurface& surface, const std::vector<double>& levels,
                  std::string caption) {
    // Lines are functions of one coordinate; of two families the larger one is followed.
    const bool is_across_x = surface.x_lines().size() >= surface.y_lines().size();
    const std::span<const SplineFunction> lines =
        is_across_x ? surface.x_lines() : surface.y_lines();
    const Rectangle& domain = surface.domain();
    const Interval across = is_across_x ? domain.x : domain.y;
    const std::vector<double> along = even_places(is_across_x ? domain.y : domain.x, rows_along);
    const std::vector<std::size_t> cells = cells_of_strips(lines, along, across);
    const std::size_t wide = places_across(lines, along[0], across, cells).size();
    const std::size_t nu = is_across_x ? wide : along.size(), nv = is_across_x ? along.size() : wide;
    SheetLayer sheet;
    sheet.nodes = Grid(nu, nv, 3);
    Grid heights(nu, nv);
    for (std::size_t r = 0; r < along.size(); ++r) {
        const std::vector<double> places = places_across(lines, along[r], across, cells);
        for (std::size_t c = 0; c < wide; ++c) {
            const std::size_t i = is_across_x ? c : r, j = is_across_x ? r : c;
            const double x = is_across_x ? places[c] : along[r];
            const double y = is_across_x ? along[r] : places[c];
            heights(i, j) = surface(x, y);
            sheet.nodes(i, j, 0) = x;
            sheet.nodes(i, j, 1) = y;
            sheet.nodes(i, j, 2) = heights(i, j);
        }
    }
    sheet.lines = level_lines_upon(heights, levels);
    Panel panel;
    panel.caption = std::move(caption);
    panel.kind = PanelKind::relief;
    panel.add(std::move(sheet));
    return panel;
}

}  // namespace batten
