#include "api/fit_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "api/criterion_panel.hpp"
#include "api/knot_marks.hpp"
#include "api/picture_text.hpp"
#include "batten/base/text.hpp"

namespace batten::api {
namespace {

constexpr int samples_a_piece = 24;
constexpr std::size_t most_error_bars = 300;  // more are a grey band of their own
constexpr double seen_share = 0.015;          // of the panel: shorter bars hide behind their dots
// How far bars and bands are shown beyond data and fit, in heights of these.
constexpr double bar_room = 0.5;
constexpr double band_room = 0.3;
constexpr std::size_t most_curve_ticks = 120;  // more would paint the curve

Panel chart(std::string caption, const std::string& x_label, std::string y_label) {
    Panel panel;
    panel.caption = std::move(caption);
    panel.kind = PanelKind::chart;
    panel.x_label = x_label;
    panel.y_label = std::move(y_label);
    return panel;
}

/// The spline or a derivative of it as runs, one for each stretch without a jump.
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

Points outline(std::span<const double> x, std::span<const double> lower,
               std::span<const double> upper) {
    Points points(0, 2);
    for (std::size_t i = 0; i < x.size(); ++i) points.push_back(std::array{x[i], lower[i]});
    for (std::size_t i = x.size(); i-- > 0;) points.push_back(std::array{x[i], upper[i]});
    return points;
}

/// Ordinates over the samples: those with weight, and those without; nothing where there is no
/// ordinate.
void add_dots(Panel& panel, const FitData& data,
              const std::vector<std::optional<double>>& ordinates,
              const std::vector<std::size_t>& rejected) {
    std::vector<char> has_weight(data.x.size(), 1);
    for (const std::size_t i : rejected) has_weight[i] = 0;
    Points kept(0, 2), left(0, 2);
    for (std::size_t i = 0; i < data.x.size(); ++i) {
        if (!ordinates[i]) continue;
        Points& some = has_weight[i] != 0 && std::isfinite(data.sigma[i]) ? kept : left;
        some.push_back(std::array{data.x[i], *ordinates[i]});
    }
    if (!kept.empty()) {
        panel.add(PointsLayer{kept, "data", Marker::open, {}, PointLabels::none, Tone::grey});
    }
    if (!left.empty()) {
        panel.add(PointsLayer{left, "no weight", Marker::closed, {}, PointLabels::none,
                              Tone::accent});
    }
}

/// Error bars where they can be seen; what they cover is added to `covered`.
void add_bars(Panel& panel, const FitData& data, Interval& covered) {
    const std::span<const double> sigma = data.sigma;
    const double tallest = *std::max_element(sigma.begin(), sigma.end());
    if (data.x.size() > most_error_bars || tallest <= seen_share * covered.length()) return;
    PolylineLayer bars{{}, "errors ±σ", {Tone::grey, Dash::solid, 0.9}};
    for (std::size_t i = 0; i < data.x.size(); ++i) {
        const double lo = data.y[i] - data.sigma[i], hi = data.y[i] + data.sigma[i];
        if (!std::isfinite(hi - lo)) continue;
        bars.runs.emplace_back(std::vector<double>{data.x[i], lo, data.x[i], hi}, 2);
        covered = {std::min(covered.lo, lo), std::max(covered.hi, hi)};
    }
    if (!bars.runs.empty()) panel.add(std::move(bars));
}

/// A spline's or a derivative's extent.
Interval extent_of_runs(const std::vector<Points>& runs) {
    Interval extent{runs.front()(0, 1), runs.front()(0, 1)};
    for (const Points& run : runs) {
        for (std::size_t i = 0; i < run.size(); ++i) {
            extent = {std::min(extent.lo, run(i, 1)), std::max(extent.hi, run(i, 1))};
        }
    }
    return extent;
}

double median(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

/// What is shown of a band: as wide as it is in the middle of its widths, and little of where it is
/// wider; between knots that are barely determined it may be a hundred times so.
Interval with_band(Interval covered, std::span<const double> lower, std::span<const double> upper) {
    covered = {std::min(covered.lo, median(lower)), std::max(covered.hi, median(upper))};
    return widened(covered, {extent_of(lower).lo, extent_of(upper).hi}, band_room);
}

Panel data_panel(const FitData& data, const Fit& fit) {
    Panel panel = chart("data and fit", data.x_name, data.y_name);
    const FitBand& band = fit.report.covariance_band;
    const std::span<const double> y = data.y;
    std::vector<Points> runs = traced(fit.spline, 0);
    const Interval level = extent_of(y), fitted = extent_of_runs(runs);
    Interval covered = level;
    add_bars(panel, data, covered);
    covered = widened(level, covered, bar_room);
    covered = {std::min(covered.lo, fitted.lo), std::max(covered.hi, fitted.hi)};
    add_dots(panel, data, {y.begin(), y.end()}, fit.report.rejected);
    if (!band.x.empty()) {
        panel.add(RegionsLayer{{outline(band.x, band.lower, band.upper)}, "95 % band",
                               Tone::accent});
        covered = with_band(covered, band.lower, band.upper);
    }
    panel.add(PolylineLayer{std::move(runs), "fit", {Tone::accent, Dash::solid, 1.8}});
    add_knot_marks(panel, fit.spline, widened(covered, covered, 0));
    return panel;
}

Panel residual_panel(const FitData& data, const Fit& fit) {
    Panel panel = chart("residuals", data.x_name, "(data − fit) / σ");
    std::vector<std::optional<double>> e(data.x.size());
    Interval y{-1, 1};
    for (std::size_t i = 0; i < e.size(); ++i) {
        if (std::isinf(data.sigma[i])) continue;
        e[i] = (data.y[i] - fit.spline(data.x[i])) / data.sigma[i];
        y = {std::min(y.lo, *e[i]), std::max(y.hi, *e[i])};
    }
    const Interval x = fit.spline.domain();
    const auto level = [&](double y) {
        return Points(std::vector<double>{x.lo, y, x.hi, y}, 2);
    };
    Points one(std::vector<double>{x.lo, -1, x.hi, -1, x.hi, 1, x.lo, 1}, 2);
    panel.add(RegionsLayer{{std::move(one)}, "±σ", Tone::blue});
    panel.add(PolylineLayer{{level(0)}, {}, {Tone::ink, Dash::solid, 0.8}});
    add_dots(panel, data, e, fit.report.rejected);
    // The band of one sigma is a part of the panel, whatever the residuals.
    add_knot_marks(panel, fit.spline, {std::min(y.lo, -2.1), std::max(y.hi, 2.1)});
    return panel;
}

Panel derivative_panel(const FitData& data, const Fit& fit) {
    Panel panel = chart("derivative", data.x_name, "d" + data.y_name + "/d" + data.x_name);
    const std::vector<Points> runs = traced(fit.spline, 1);
    std::vector<double> lower, upper, x;
    Interval covered = extent_of_runs(runs);
    if (fit.report.undetermined.empty() && fit.spline.degree() > 1) {
        const double factor = fit.covariance.factor_95();
        const Interval domain = fit.spline.domain();
        for (int i = 0; i <= 200; ++i) {
            const double at = domain.clamp(domain.lo + domain.length() * (i / 200.0));
            const double half = factor * fit.covariance.deviation(at, 1);
            x.push_back(at);
            lower.push_back(fit.spline(at, 1) - half);
            upper.push_back(fit.spline(at, 1) + half);
        }
        panel.add(RegionsLayer{{outline(x, lower, upper)}, "95 % band", Tone::accent});
        covered = with_band(covered, lower, upper);
    }
    panel.add(PolylineLayer{runs, "fit", {Tone::accent, Dash::solid, 1.8}});
    add_knot_marks(panel, fit.spline, widened(covered, covered, 0));
    return panel;
}

std::string subtitle(const FitReport& report) {
    std::string text = counted(report.samples, "sample", "samples") + ", " +
                       counted(static_cast<std::size_t>(report.intervals), "interval",
                               "intervals") +
                       ", δ² = " + format_fixed(report.delta2, 2);
    if (report.chi2_p) text += ", χ² p " + probability_text(*report.chi2_p);
    if (report.sigma_source == SigmaSource::estimated) text += ", σ estimated";
    return text;
}

}  // namespace

Drawing fit_picture(const FitData& data, const Fit& fit, const FitOptions& options) {
    Drawing drawing;
    drawing.title = "Least-squares spline of " + data.y_name + "(" + data.x_name + ")";
    drawing.subtitle = subtitle(fit.report);
    drawing.width = 1000;
    drawing.columns = 2;
    drawing.panels = {data_panel(data, fit), residual_panel(data, fit)};
    if (fit.report.path.size() > 1) drawing.panels.push_back(criterion_panel(fit.report, options));
    if (fit.spline.degree() > 0) drawing.panels.push_back(derivative_panel(data, fit));
    return drawing;
}

Drawing fit_curve_picture(PointsView points, const CurveFit& fit, const FitOptions& options) {
    Drawing drawing;
    drawing.title = "Least-squares curve near " + std::to_string(points.size()) + " points";
    drawing.subtitle = subtitle(fit.report);
    drawing.width = 1000;
    drawing.panels[0].caption = "points and curve";
    const Curve curve(fit.curve);
    drawing.add(PointsLayer{Points(points), "data", Marker::open, {}, PointLabels::none, Tone::grey});
    drawing.add(CurveLayer{curve, "fit", {Tone::accent, Dash::solid, 1.8}});
    std::vector<double> at(curve.breaks().begin(), curve.breaks().end());
    if (at.size() <= most_curve_ticks) {
        drawing.add(TicksLayer{curve, at, "knots"});
    } else {
        drawing.panels[0].caption += ", its " + std::to_string(at.size()) + " knots too dense to show";
    }
    if (fit.report.path.size() > 1) drawing.panels.push_back(criterion_panel(fit.report, options));
    return drawing;
}

}  // namespace batten::api
