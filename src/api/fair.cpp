#include "batten/make/fair.hpp"

#include <algorithm>
#include <cmath>

#include "api/row.hpp"
#include "batten/make/interpolate.hpp"
#include "io/draw/axes/ticks.hpp"

namespace batten::api {
namespace {

/// Curvature of the circle through three points against the chords' length.
Points curvature_of(PointsView points) {
    Points chart(0, 2);
    double s = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const auto p = points[i - 1], q = points[i], r = points[i + 1];
        const double ax = q[0] - p[0], ay = q[1] - p[1], bx = r[0] - q[0], by = r[1] - q[1];
        s += std::hypot(ax, ay);
        const double size = std::hypot(ax, ay) * std::hypot(bx, by) * std::hypot(ax + bx, ay + by);
        if (size > 0) chart.push_back(std::vector{s, 2 * (ax * by - ay * bx) / size});
    }
    return chart;
}

Panel curvature_panel(PointsView before, PointsView after) {
    constexpr double air = 0.12;
    const Points given = curvature_of(before), fair = curvature_of(after);
    double least = fair(0, 1), most = least;
    for (std::size_t i = 0; i < fair.size(); ++i) {
        least = std::fmin(least, fair(i, 1));
        most = std::fmax(most, fair(i, 1));
    }
    const double margin = air * (most - least);
    Panel panel;
    panel.caption = "curvature along the points";
    panel.kind = PanelKind::chart;
    panel.x_label = "arc length";
    if (margin > 0) panel.y_range = Interval{least - margin, most + margin};
    // Dots: joined by lines, the curvature of noise fills the panel.
    panel.add(PointsLayer{given, "points", Marker::open, {}, PointLabels::none, Tone::grey});
    panel.add(PolylineLayer{{fair}, "faired", {Tone::accent}});
    return panel;
}

/// Smooth through the faired points, as a polyline would not look.
Curve through(const Points& points, bool closed) {
    const std::size_t n = points.size();
    const bool repeats = closed && std::equal(points[0].begin(), points[0].end(),
                                              points[n - 1].begin());
    InterpolateOptions options;
    options.method = Method::natural_chord;
    options.closed = closed;
    return interpolate(PointsView(points).part(0, repeats ? n - 1 : n), options).curve;
}

std::string subtitle(const FairReport& report) {
    const auto number = drawing::short_number;
    return "α = " + number(report.alpha) + ", σ = " + number(report.sigma) + ", moved by " +
           number(report.rms_displacement) + " rms, " + number(report.max_displacement) +
           " at most";
}

Drawing picture(PointsView points, const Fairing& made, const FairOptions& options) {
    Drawing drawing;
    drawing.title = std::to_string(points.size()) + " points made fair";
    drawing.subtitle = subtitle(made.report);
    drawing.panels.front().caption = "points and curve";
    drawing.add(PointsLayer{Points(points), "points", Marker::open, {}, PointLabels::none, Tone::grey});
    if (made.curve) {
        drawing.add(CurveLayer{*made.curve, "faired", {Tone::accent}});
        drawing.add(TicksLayer{*made.curve,
                               {made.curve->breaks().begin(), made.curve->breaks().end()}});
    } else {
        drawing.add(CurveLayer{through(made.points, options.closed), "faired", {Tone::accent}});
    }
    if (points.dim() == 2) {
        drawing.panels.push_back(curvature_panel(points, made.points));
        drawing.columns = 1;
    }
    return drawing;
}

std::vector<std::string> names_of(const PointsInput& input) {
    std::vector<std::string> names;
    for (const int column : input.columns) {
        const std::size_t at = static_cast<std::size_t>(column);
        if (at < input.table.names.size()) names.push_back(input.table.names[at]);
    }
    return names;
}

Outcome run(std::span<const Input> inputs, const FairOptions& options) {
    const PointsInput& input = points_input(inputs);
    const SharedPoints points = points_of(input);
    Fairing made = naming_lines(input, [&] { return fair(points, options); });
    made.report.notes.insert(made.report.notes.begin(), input.table.notes.begin(),
                             input.table.notes.end());
    Output output = Rows{names_of(input), made.points};
    if (made.curve) output = Curve(*made.curve);
    return {std::move(output), made.report.status, {}, report_value(made.report),
            [points, made, options] { return picture(points, made, options); }};
}

}  // namespace

Operation fair_row() {
    return row<FairOptions>({"fair", "noisy points made fair, moved to log-aesthetic curves",
                             InputKind::points, OutputKind::rows},
                            run);
}

}  // namespace batten::api
