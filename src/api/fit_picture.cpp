#include "api/fit_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "batten/base/text.hpp"

namespace batten::api {
namespace {

constexpr int samples_a_piece = 24;
constexpr std::size_t most_error_bars = 300;  // more are a grey band of their own
constexpr double tick_share = 0.035;          // height of a knot's tick in its panel
constexpr double seen_share = 0.015;          // of the panel: shorter bars hide behind their dots
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

Interval range_of(std::span<const double> values) {
    const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
    return {*lo, *hi};
}

/// Short marks at the knots along the bottom of a chart whose data cover `y`.
PolylineLayer knot_ticks(std::span<const double> breaks, Interval y) {
    const double length = y.hi > y.lo ? y.hi - y.lo : 1;
    const double foot = y.lo - 2 * tick_share * length;
    PolylineLayer ticks{{}, "knots", {Tone::blue, Dash::solid, 1.3}};
    for (const double x : breaks) {
        ticks.runs.emplace_back(std::vector<double>{x, foot, x, foot + tick_share * length}, 2);
    }
    return ticks;
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

Panel data_panel(const FitData& data, const Fit& fit) {
    Panel panel = chart("data and fit", data.x_name, data.y_name);
    const FitBand& band = fit.report.covariance_band;
    const Interval level = range_of(data.y);
    const std::span<const double> sigma = data.sigma, y = data.y;
    const double tallest = *std::max_element(sigma.begin(), sigma.end());
    if (data.x.size() <= most_error_bars && tallest > seen_share * level.length()) {
        PolylineLayer bars{{}, "errors ±σ", {Tone::grey, Dash::solid, 0.9}};
        for (std::size_t i = 0; i < data.x.size(); ++i) {
            const double lo = data.y[i] - data.sigma[i], hi = data.y[i] + data.sigma[i];
            if (!std::isfinite(hi - lo)) continue;
            bars.runs.emplace_back(std::vector<double>{data.x[i], lo, data.x[i], hi}, 2);
        }
        if (!bars.runs.empty()) panel.add(std::move(bars));
    }
    add_dots(panel, data, {y.begin(), y.end()}, fit.report.rejected);
    if (!band.x.empty()) {
        panel.add(RegionsLayer{{outline(band.x, band.lower, band.upper)}, "95 % band",
                               Tone::accent});
    }
    panel.add(PolylineLayer{traced(fit.spline, 0), "fit", {Tone::accent, Dash::solid, 1.8}});
    panel.add(knot_ticks(fit.spline.breaks(), range_of(data.y)));
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
    y = {std::min(1.08 * y.lo, -2.2), std::max(1.08 * y.hi, 2.2)};
    panel.add(knot_ticks(fit.spline.breaks(), y));
    panel.y_range = Interval{y.lo - 3 * tick_share * y.length(), y.hi};
    return panel;
}

/// Air around counts; so wide that the numbers along the axis are whole.
Interval whole_range(double first, double last) {
    constexpr double narrowest = 6, air = 0.04;
    const double lo = std::min(first, last), hi = std::max(first, last);
    const double half = std::max(0.5 * narrowest, (0.5 + air) * (hi - lo));
    return {0.5 * (lo + hi) - half, 0.5 * (lo + hi) + half};
}

/// Rounded, but never to a certainty that it is not.
std::string probability(double p) {
    constexpr double nearly = 0.0005;
    if (p > 1 - nearly && p < 1) return "> 0.999";
    if (p < nearly && p > 0) return "< 0.001";
    return "= " + format_fixed(p, 3);
}

Panel criterion_panel(const FitReport& report, const FitOptions& options) {
    const StopRule rule = options.stop;
    const std::string name(is_criterion(rule) ? name_of(rule) : name_of(StopRule::bic));
    const bool is_shaped = options.monotone != Direction::free || options.convex != Direction::free;
    Panel panel = chart(options.knots == KnotPlacement::pruned ? "criterion, before knots are pruned"
                        : is_shaped ? "criterion, without the shape asked for"
                                    : "criterion",
                        "intervals", name);
    // Knots that are pruned afterwards are not on the path.
    const bool is_on_path = options.knots != KnotPlacement::pruned;
    Points line(0, 2), chosen(0, 2);
    std::vector<double> values;
    double least = criterion_of(report.path.front(), rule);
    for (const FitStep& step : report.path) {
        const std::array<double, 2> here{static_cast<double>(step.intervals),
                                         criterion_of(step, rule)};
        line.push_back(here);
        values.push_back(here[1]);
        least = std::min(least, here[1]);
        if (is_on_path && step.intervals == report.intervals) chosen.push_back(here);
    }
    // The first steps are far worse than any other and would flatten the rest.
    if (line.size() > 3) {
        // Half of the steps are shown, though, and the one chosen.
        const double last = line(line.size() - 1, 1);
        std::sort(values.begin(), values.end());
        double shown = std::max(last, values[values.size() / 2]);
        if (!chosen.empty()) shown = std::max(shown, chosen(0, 1));
        const double top = least + 1.4 * std::max(shown - least, 0.02 * std::fabs(least));
        const double first = line(0, 1);
        if (top < first && last < top) {
            const double air = 0.08 * (top - least);
            panel.y_range = Interval{least - air, top};
        }
    }
    panel.x_range = whole_range(line(0, 0), line(line.size() - 1, 0));
    panel.add(PolylineLayer{{line}, {}, {Tone::grey, Dash::solid, 1.2}});
    panel.add(PointsLayer{line, {}, Marker::open, {}, PointLabels::none, Tone::ink});
    if (!chosen.empty()) {
        panel.add(PointsLayer{chosen, "chosen", Marker::closed, {}, PointLabels::none,
                              Tone::accent});
    }
    return panel;
}

Panel derivative_panel(const FitData& data, const Fit& fit) {
    Panel panel = chart("derivative", data.x_name, "d" + data.y_name + "/d" + data.x_name);
    const std::vector<Points> runs = traced(fit.spline, 1);
    std::vector<double> lower, upper, x, values;
    for (const Points& run : runs) {
        for (std::size_t i = 0; i < run.size(); ++i) values.push_back(run(i, 1));
    }
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
    }
    panel.add(PolylineLayer{runs, "fit", {Tone::accent, Dash::solid, 1.8}});
    panel.add(knot_ticks(fit.spline.breaks(), range_of(values)));
    return panel;
}

std::string subtitle(const FitReport& report) {
    std::string text = std::to_string(report.samples) + " samples, " +
                       std::to_string(report.intervals) +
                       (report.intervals == 1 ? " interval, " : " intervals, ") + "δ² = " +
                       format_fixed(report.delta2, 2);
    if (report.chi2_p) text += ", χ² p " + probability(*report.chi2_p);
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
