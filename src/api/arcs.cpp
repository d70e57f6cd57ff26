#include "batten/make/arcs.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "api/machine_options.hpp"
#include "api/row.hpp"

namespace batten::api {
namespace {

struct ArcsRequest {
    ArcsOptions arcs;
    MachineOptions machine;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, ArcsRequest>
void visit_fields(Options& o, Visit&& visit) {
    visit_fields(o.arcs, visit);
    visit_fields(o.machine, visit);
}

/// What an arc is drawn as: by the side to which it turns.
enum class Turn { left, right, straight };

Turn turn_of(double bulge) {
    return bulge > 0 ? Turn::left : bulge < 0 ? Turn::right : Turn::straight;
}

/// The chain in runs that turn to one side; each side's name stands in the legend once.
void add_arcs(Drawing& drawing, const ArcChain& chain) {
    const auto style = [](Turn turn) {
        return turn == Turn::left    ? std::pair("turns left", Tone::blue)
               : turn == Turn::right ? std::pair("turns right", Tone::ochre)
                                     : std::pair("straight", Tone::teal);
    };
    const std::span<const double> breaks = chain.breaks();
    std::size_t from = 0;
    for (std::size_t i = 1; i <= chain.arcs(); ++i) {
        const Turn turn = turn_of(chain.bulges()[from]);
        if (i < chain.arcs() && turn_of(chain.bulges()[i]) == turn) continue;
        const auto [name, tone] = style(turn);
        drawing.add(CurveLayer{trimmed(chain, {breaks[from], breaks[i]}), name,
                               {tone, Dash::solid, 2.2}});
        from = i;
    }
}

/// Each arc's error over the arc's own length.
Panel error_chart(const ArcFit& fit) {
    Panel panel;
    panel.kind = PanelKind::chart;
    panel.caption = "distance from what was given";
    panel.x_label = "arc length";
    panel.y_label = "error of each arc";
    PolylineLayer steps{{}, {}, {Tone::accent}};
    Points line(0, 2);
    for (std::size_t i = 0; i < fit.chain.arcs(); ++i) {
        for (const double s : {fit.chain.breaks()[i], fit.chain.breaks()[i + 1]}) {
            line.push_back(std::array{s, fit.report.arc[i].error});
        }
    }
    steps.runs.push_back(std::move(line));
    panel.add(std::move(steps));
    return panel;
}

Drawing picture(const ArcFit& fit, const Layer& given) {
    Drawing drawing;
    drawing.panels.front().caption = "arcs and lines, a tick at every joint";
    drawing.add(given);
    add_arcs(drawing, fit.chain);
    const std::span<const double> joints = fit.chain.breaks();
    drawing.add(TicksLayer{fit.chain, {joints.begin(), joints.end()}, {}, Tone::ink});
    // A chain through all points has no error to show: then how its curvature changes.
    drawing.panels.push_back(fit.report.max_error > 0 ? error_chart(fit)
                                                      : curvature_plot(fit.chain));
    if (fit.report.max_error == 0) drawing.panels.back().caption = "curvature of the arcs";
    return drawing;
}

/// `given` makes the layer of what was given, when a picture is wanted.
Outcome outcome(ArcFit fit, const ArcsRequest& request, std::function<Layer()> given) {
    const Curve curve = fit.chain;
    const Status status = fit.report.status;
    Value report = report_value(fit.report);
    return {curve, status, {}, std::move(report),
            [fit = std::move(fit), given = std::move(given)] { return picture(fit, given()); },
            machine_forms(curve, request.machine)};
}

Outcome run(std::span<const Input> inputs, const ArcsRequest& request) {
    if (inputs.size() == 1 && std::holds_alternative<Curve>(inputs.front().content)) {
        const Curve& curve = curve_input(inputs);
        return outcome(arcs(curve, request.arcs), request,
                       [curve] {
                           return CurveLayer{curve, "curve given", {Tone::grey, Dash::solid, 5.0}};
                       });
    }
    const PointsInput& input = points_input(inputs);
    const SharedPoints points = points_of(input);
    ArcFit fit = naming_lines(input, [&] { return arcs(points.view(), request.arcs); });
    fit.report.notes.insert(fit.report.notes.begin(), input.table.notes.begin(),
                            input.table.notes.end());
    return outcome(std::move(fit), request,
                   [points] { return PointsLayer{Points(points), "points given"}; });
}

}  // namespace

Operation arcs_row() {
    return row<ArcsRequest>({"arcs", "circular arcs and lines through points or along a curve",
                         InputKind::points_or_curve, OutputKind::curve, {"gcode"}},
                        run);
}

}  // namespace batten::api
