#include "api/criterion_panel.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace batten::api {
namespace {

/// Air around counts; so wide that the numbers along the axis are whole.
Interval whole_range(double first, double last) {
    constexpr double narrowest = 6, air = 0.04;
    const double lo = std::min(first, last), hi = std::max(first, last);
    const double half = std::max(0.5 * narrowest, (0.5 + air) * (hi - lo));
    // There are no counts below 1.
    const double start = std::max(0.5 * (lo + hi) - half, 0.0);
    return {start, start + 2 * half};
}

/// The criterion as people write it.
std::string as_written(std::string_view name) {
    if (name == "aicc") return "AICc";
    std::string text(name);
    for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return text;
}

}  // namespace

Panel criterion_panel(const FitReport& report, const FitOptions& options) {
    const StopRule rule = options.stop;
    const std::string name = as_written(name_of(is_criterion(rule) ? rule : StopRule::bic));
    const bool is_shaped = options.monotone != Direction::free || options.convex != Direction::free;
    Panel panel;
    panel.kind = PanelKind::chart;
    panel.caption = options.knots == KnotPlacement::pruned ? "criterion, before knots are pruned"
                    : is_shaped ? "criterion, without the shape asked for"
                                : "criterion";
    panel.x_label = "intervals";
    panel.y_label = name;
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

}  // namespace batten::api
