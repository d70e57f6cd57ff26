#include "batten/make/sample.hpp"

#include <algorithm>

#include "api/row.hpp"
#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::api {
namespace {

std::vector<double> column(const Sampling& made, const char* name) {
    const auto at = std::find(made.names.begin(), made.names.end(), name);
    const int k = static_cast<int>(at - made.names.begin());
    std::vector<double> result;
    for (std::size_t i = 0; i < made.rows.size(); ++i) result.push_back(made.rows(i, k));
    return result;
}

/// Speed against time: the law as a line, the samples as dots on it.
Panel speed_plot(const Sampling& made) {
    constexpr std::size_t most_dots = 100;
    const std::vector<double> time = column(made, "time"), speed = column(made, "speed");
    Points dots(time.size(), 2);
    double fastest = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        dots(i, 0) = time[i];
        dots(i, 1) = speed[i];
        fastest = std::max(fastest, speed[i]);
    }
    Points line(2);
    if (made.speeds.empty()) {
        line = dots;
    } else {
        line.push_back(dots[0]);
        for (std::size_t i = 0; i < made.speeds.size(); ++i) {
            line.push_back(made.speeds[i]);
            fastest = std::max(fastest, made.speeds(i, 1));
        }
        line.push_back(dots[dots.size() - 1]);
    }
    Panel panel;
    panel.kind = PanelKind::chart;
    panel.caption = "speed over time";
    panel.x_label = "time";
    panel.y_label = "speed";
    panel.add(PolylineLayer{{line}, {}, {Tone::blue}});
    if (dots.size() <= most_dots) {
        panel.add(PointsLayer{dots, {}, Marker::closed, {}, PointLabels::none, Tone::blue});
    }
    if (fastest > 0) panel.y_range = Interval{0, 1.08 * fastest};
    return panel;
}

Drawing picture(const Curve& curve, const std::optional<SharedPoints>& points, const Sampling& made,
                const SampleOptions& options) {
    Drawing drawing;
    drawing.columns = 1;
    Panel& walk = drawing.panels.front();
    walk.caption = std::to_string(made.report.samples) + " samples by law " +
                   std::string(name_of(options.law));
    walk.add(CurveLayer{curve, {}, {}});
    walk.add(TicksLayer{curve, column(made, "t"), {}, Tone::blue});
    if (points) walk.add(PointsLayer{Points(*points), "points"});
    drawing.panels.push_back(speed_plot(made));
    return drawing;
}

Outcome outcome_of(const Curve& curve, const std::optional<SharedPoints>& points, Sampling made,
                   const SampleOptions& options) {
    const SampleReport report = made.report;
    Rows rows{made.names, made.rows};
    return {std::move(rows), report.status, {}, report_value(report),
            [=] { return picture(curve, points, made, options); }};
}

Outcome run(std::span<const Input> inputs, const SampleOptions& options) {
    if (options.method == SampleMethod::exact) {
        const Curve& curve = curve_input(inputs);
        return outcome_of(curve, std::nullopt, sample(curve, options), options);
    }
    const PointsInput& input = points_input(inputs);
    const SharedPoints points = points_of(input);
    return naming_lines(input, [&] {
        return outcome_of(harada_nakamae_curve(points), points,
                          sample_harada_nakamae(points, options), options);
    });
}

}  // namespace

Operation sample_row() {
    return row<SampleOptions>(
        {"sample", "points on a curve by a law of motion", InputKind::points_or_curve,
         OutputKind::rows},
        run);
}

}  // namespace batten::api
