#include "api/fit_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "api/criterion_panel.hpp"
#include "api/knot_marks.hpp"
#include "api/picture_text.hpp"
#include "api/spline_panel.hpp"
#include "batten/base/text.hpp"

namespace batten::api {
namespace {

constexpr std::size_t most_error_bars = 300;  // more are a grey band of their own
constexpr double seen_share = 0.015;          // of the panel: shorter bars hide behind their dots
// How far bars are shown beyond data and fit, in heights of these.
constexpr double bar_room = 0.5;
constexpr const char* band_name = "95 % band";
constexpr std::size_t most_curve_ticks = 120;  // more would paint the curve

/// Dots with weight, and those without.
void add_dots(Panel& panel, const Points& kept, const Points& left) {
    if (!kept.empty()) {
        panel.add(PointsLayer{kept, "data", Marker::open, {}, PointLabels::none, Tone::ink});
    }
    if (!left.empty()) {
        panel.add(PointsLayer{left, "no weight", Marker::closed, {}, PointLabels::none,
                              Tone::ochre});
    }
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
    add_dots(panel, kept, left);
}

/// Error bars where they can be seen; what they cover is added to `covered`.
void add_bars(Panel& panel, const FitData& data, Interval& covered) {
    const std::span<const double> sigma = data.sigma;
    const double tallest = *std::max_element(sigma.begin(), sigma.end());
    if (data.x.size() > most_error_bars || tallest <= seen_share * covered.length()) return;
    PolylineLayer bars{{}, "errors ±σ", {Tone::grey, Dash::solid, 0.7}};
    for (std::size_t i = 0; i < data.x.size(); ++i) {
        const double lo = data.y[i] - data.sigma[i], hi = data.y[i] + data.sigma[i];
        if (!std::isfinite(hi - lo)) continue;
        bars.runs.emplace_back(std::vector<double>{data.x[i], lo, data.x[i], hi}, 2);
        covered = {std::min(covered.lo, lo), std::max(covered.hi, hi)};
    }
    if (!bars.runs.empty()) panel.add(std::move(bars));
}

/// Where the next measurements tell most.
void add_suggestions(Panel& panel, const std::vector<double>& places, Interval content) {
    PolylineLayer lines{{}, "suggested", {Tone::teal, Dash::dashed, 1.2}};
    for (const double x : places) {
        lines.runs.emplace_back(std::vector<double>{x, content.lo, x, content.hi}, 2);
    }
    if (!lines.runs.empty()) panel.add(std::move(lines));
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
    // A few samples lie upon the line, many would hide it.
    const bool are_few = data.x.size() <= most_error_bars;
    if (!are_few) add_dots(panel, data, {y.begin(), y.end()}, fit.report.rejected);
    if (!band.x.empty()) {
        panel.add(band_layer(band.x, band.lower, band.upper, band_name));
        covered = covering_band(covered, band.lower, band.upper);
    }
    panel.add(PolylineLayer{std::move(runs), "fit", {Tone::accent, Dash::solid, 1.8}});
    if (are_few) add_dots(panel, data, {y.begin(), y.end()}, fit.report.rejected);
    const Interval content = widened(covered, covered, 0);
    add_suggestions(panel, fit.report.suggestions, content);
    add_knot_marks(panel, fit.spline, content);
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

/// The distance of point i from its place on the curve; in the plane positive to the left.
double distance_from(const Jet& jet, std::span<const double> point) {
    double sum = 0;
    for (std::size_t k = 0; k < point.size(); ++k) {
        sum += (point[k] - jet[0][k]) * (point[k] - jet[0][k]);
    }
    const bool is_right = point.size() == 2 && jet[1][0] * (point[1] - jet[0][1]) <
                                                   jet[1][1] * (point[0] - jet[0][0]);
    return is_right ? -std::sqrt(sum) : std::sqrt(sum);
}

Panel distance_panel(const CurveFitData& data, const CurveFit& fit, const Curve& curve) {
    const bool is_plane = data.points.dim() == 2;
    Panel panel = chart(is_plane ? "residuals, positive on the left" : "residuals", "t",
                        "distance / σ");
    std::vector<char> has_weight(data.points.size(), 1);
    for (const std::size_t i : fit.report.rejected) has_weight[i] = 0;
    Points kept(0, 2), left(0, 2);
    Interval y{is_plane ? -1.0 : 0.0, 1};
    for (std::size_t i = 0; i < data.points.size(); ++i) {
        const double sigma = data.sigma.empty() ? fit.report.sigma.value_or(1) : data.sigma[i];
        if (!std::isfinite(sigma) || !(sigma > 0)) continue;
        const double t = curve.domain().clamp(fit.parameters[i]);
        const double e = distance_from(curve.jet(t, 1), data.points.view()[i]) / sigma;
        (has_weight[i] != 0 ? kept : left).push_back(std::array{t, e});
        y = {std::min(y.lo, e), std::max(y.hi, e)};
    }
    const Interval x = curve.domain();
    const double low = is_plane ? -1 : 0;
    Points one(std::vector<double>{x.lo, low, x.hi, low, x.hi, 1, x.lo, 1}, 2);
    panel.add(RegionsLayer{{std::move(one)}, "±σ", Tone::blue});
    panel.add(PolylineLayer{{Points(std::vector<double>{x.lo, 0, x.hi, 0}, 2)}, {},
                            {Tone::ink, Dash::solid, 0.8}});
    add_dots(panel, kept, left);
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
    if (fit.spline.degree() > 0) {
        const bool is_known = fit.report.undetermined.empty();
        const FitCovariance* const covariance = is_known ? &fit.covariance : nullptr;
        drawing.panels.push_back(
            derivative_panel(fit.spline, 1, {data.x_name, data.y_name},
                             {covariance, is_known ? covariance->factor_95() : 0, band_name},
                             "fit"));
    }
    return drawing;
}

Drawing fit_curve_picture(const CurveFitData& data, const CurveFit& fit,
                          const FitOptions& options) {
    Drawing drawing;
    drawing.title =
        "Least-squares curve near " + std::to_string(data.points.size()) + " points";
    drawing.subtitle = subtitle(fit.report);
    drawing.width = 1000;
    Panel& plane = drawing.panels[0];
    plane.caption = "points and curve";
    plane.x_label = data.names[0];
    plane.y_label = data.names[1];
    if (data.names.size() > 2) plane.z_label = data.names[2];
    const Curve curve(fit.curve);
    plane.add(PointsLayer{Points(data.points), "data", Marker::open, {}, PointLabels::none,
                          Tone::ink});
    plane.add(CurveLayer{curve, "fit", {Tone::accent, Dash::solid, 1.8}});
    std::vector<double> at(curve.breaks().begin(), curve.breaks().end());
    if (at.size() <= most_curve_ticks) {
        plane.add(TicksLayer{curve, at, "knots"});
    } else {
        plane.caption += ", its " + std::to_string(at.size()) + " knots too dense to show";
    }
    drawing.panels.push_back(distance_panel(data, fit, curve));
    if (fit.report.path.size() > 1) drawing.panels.push_back(criterion_panel(fit.report, options));
    return drawing;
}

}  // namespace batten::api
