#include "api/spline_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "api/knot_marks.hpp"
#include "batten/shape/spline_graph.hpp"

namespace batten::api {
namespace {

constexpr int samples_a_piece = 24;
constexpr int band_steps = 200;  // over the domain, and in a piece at least
constexpr int least_steps = 8;
constexpr std::size_t longest_names = 32;  // bytes of both that a quotient is written of
// How far bands are shown beyond what they surround, in heights of it.
constexpr double band_room = 0.3;

Points outline(std::span<const double> x, std::span<const double> lower,
               std::span<const double> upper) {
    Points points(0, 2);
    for (std::size_t i = 0; i < x.size(); ++i) points.push_back(std::array{x[i], lower[i]});
    for (std::size_t i = x.size(); i-- > 0;) points.push_back(std::array{x[i], upper[i]});
    return points;
}

double median(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

/// A small number above the line.
std::string raised(int order) {
    constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    return digits[static_cast<std::size_t>(order)];
}

/// The edges of a band at abscissae.
struct BandEdges {
    std::vector<double> x, lower, upper;
};

/// The band `factor` deviations wide on either side of the spline or of a derivative.
BandEdges band_around(const SplineFunction& spline, int derivative,
                      const FitCovariance& covariance, double factor) {
    BandEdges edges;
    const std::span<const double> breaks = spline.breaks();
    const int steps = std::max(least_steps, band_steps / static_cast<int>(spline.pieces()));
    for (std::size_t i = 0; i < spline.pieces(); ++i) {
        for (int k = i == 0 ? 0 : 1; k <= steps; ++k) {
            const double at = k == steps ? breaks[i + 1]
                                         : breaks[i] + (breaks[i + 1] - breaks[i]) * k / steps;
            const double half = factor * covariance.deviation(at, derivative);
            const double value = spline.value_on(i, at, derivative);
            edges.x.push_back(at);
            edges.lower.push_back(value - half);
            edges.upper.push_back(value + half);
        }
    }
    return edges;
}

/// The spline or a derivative, its band where that does not jump at every knot, and the knots.
void add_spline(Panel& panel, const SplineFunction& spline, int order, const NamedBand& band,
                std::string name) {
    std::vector<Points> runs = traced(spline, order);
    Interval covered = extent_of_runs(runs);
    if (band.covariance && (order == 0 || spline.degree() > order)) {
        const BandEdges edges = band_around(spline, order, *band.covariance, band.factor);
        panel.add(band_layer(edges.x, edges.lower, edges.upper, band.name));
        covered = covering_band(covered, edges.lower, edges.upper);
    }
    panel.add(PolylineLayer{std::move(runs), std::move(name), {Tone::accent, Dash::solid, 1.8}});
    add_knot_marks(panel, spline, widened(covered, covered, 0));
}

}  // namespace

std::string name_of_derivative(const AxisNames& names, int order) {
    if (order == 0) return names.y;
    const std::string power = order > 1 ? raised(order) : "";
    const bool is_short = names.x.size() + names.y.size() <= longest_names;
    const AxisNames shown = is_short ? names : AxisNames{};
    return "d" + power + shown.y + "/d" + shown.x + power;
}

Panel chart(std::string caption, std::string x_label, std::string y_label) {
    Panel panel;
    panel.caption = std::move(caption);
    panel.kind = PanelKind::chart;
    panel.x_label = std::move(x_label);
    panel.y_label = std::move(y_label);
    return panel;
}

std::optional<SplineFunction> function_of(const Curve& curve) {
    if (const SplineGraph* const graph = curve.shape<SplineGraph>()) return graph->spline();
    return spline_of_graph(curve);
}

std::vector<Points> traced(const SplineFunction& spline, int derivative) {
    std::vector<Points> runs;
    const std::span<const double> breaks = spline.breaks();
    for (std::size_t i = 0; i < spline.pieces(); ++i) {
        const double start = spline.value_on(i, breaks[i], derivative);
        const bool jumps = runs.empty() || runs.back()(runs.back().size() - 1, 1) != start;
        const bool is_near = !runs.empty() &&
                             std::fabs(runs.back()(runs.back().size() - 1, 1) - start) <=
                                 1e-9 * (std::fabs(start) + 1);
        if (runs.empty() || (jumps && !is_near)) runs.emplace_back(0, 2);
        for (int k = 0; k <= samples_a_piece; ++k) {
            const double x = k == samples_a_piece ? breaks[i + 1]
                                                  : breaks[i] + (breaks[i + 1] - breaks[i]) * k /
                                                                    samples_a_piece;
            runs.back().push_back(std::array{x, spline.value_on(i, x, derivative)});
        }
    }
    return runs;
}

Interval extent_of_runs(const std::vector<Points>& runs) {
    Interval extent{runs.front()(0, 1), runs.front()(0, 1)};
    for (const Points& run : runs) {
        for (std::size_t i = 0; i < run.size(); ++i) {
            extent = {std::min(extent.lo, run(i, 1)), std::max(extent.hi, run(i, 1))};
        }
    }
    return extent;
}

RegionsLayer band_layer(std::span<const double> x, std::span<const double> lower,
                        std::span<const double> upper, std::string name) {
    return {{outline(x, lower, upper)}, std::move(name), Tone::accent};
}

Interval covering_band(Interval covered, std::span<const double> lower,
                       std::span<const double> upper) {
    covered = {std::min(covered.lo, median(lower)), std::max(covered.hi, median(upper))};
    return widened(covered, {extent_of(lower).lo, extent_of(upper).hi}, band_room);
}

Panel value_panel(const SplineFunction& spline, const AxisNames& names, const NamedBand& band,
                  std::string name) {
    Panel panel = chart("values", names.x, names.y);
    add_spline(panel, spline, 0, band, std::move(name));
    return panel;
}

Panel derivative_panel(const SplineFunction& spline, int order, const AxisNames& names,
                       const NamedBand& band, std::string name) {
    Panel panel = chart(order == 1 ? "derivative" : "derivative " + std::to_string(order), names.x,
                        name_of_derivative(names, order));
    add_spline(panel, spline, order, band, std::move(name));
    return panel;
}

}  // namespace batten::api
