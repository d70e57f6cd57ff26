#include <array>
#include <cmath>

#include "batten/base/text.hpp"
#include "batten/io/draw/drawing.hpp"
#include "batten/measure/curvature_graph.hpp"

namespace batten {
namespace {

/// Three decimals: more than a picture can show.
std::string rounded(double x) {
    const std::string text = format_number(std::round(std::fabs(x) * 1000) / 1000);
    return (x < 0 && text != "0" ? "−" : "") + text;
}

/// The graph of a radius of this sign, ρ or μ, with its line.
Panel graph_panel(const LogarithmicGraph& graph, const std::string& radius,
                  const std::string& name) {
    Panel panel;
    panel.kind = PanelKind::chart;
    panel.x_label = "log " + radius;
    panel.y_label = "log |" + radius + " ds/d" + radius + "|";
    panel.add(PointsLayer{graph.points, name, Marker::closed, {}, PointLabels::none, Tone::blue});
    if (graph.line) {
        double least = graph.points(0, 0), most = least;
        for (std::size_t i = 0; i < graph.points.size(); ++i) {
            least = std::fmin(least, graph.points(i, 0));
            most = std::fmax(most, graph.points(i, 0));
        }
        const auto& [slope, error, intercept] = *graph.line;
        Points ends(0, 2);
        ends.push_back(std::array{least, intercept + slope * least});
        ends.push_back(std::array{most, intercept + slope * most});
        panel.add(PolylineLayer{{ends}, {}, {Tone::accent, Dash::solid, 1.2}});
        panel.caption = "slope " + rounded(slope) + " ± " + rounded(error);
    }
    return panel;
}

}  // namespace

Panel curvature_graph_plot(const Curve& curve, const std::string& name) {
    return graph_panel(curvature_graph(curve), "ρ", name);
}

Panel torsion_graph_plot(const Curve& curve, const std::string& name) {
    return graph_panel(torsion_graph(curve), "μ", name);
}

}  // namespace batten
