#include "io/draw/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "io/draw/check.hpp"
#include "io/draw/scene/theme.hpp"
#include "io/draw/shapes/bend.hpp"
#include "io/draw/toning.hpp"

namespace batten::drawing {
namespace {

/// The share of a chart's side that stays free beyond the data, on both sides.
constexpr double chart_air_x = 0.03;
constexpr double chart_air_y = 0.06;

/// Makes one layer ready, all but its comb, and adds to the box what it covers.
struct Preparation {
    AxisUnits units;
    Toning& toning;
    ReadyLayer& ready;
    Box& box;
    double& padding;

    void pad(double pixels) { padding = std::max(padding, pixels); }

    void operator()(const CurveLayer& layer) {
        ready.tone = toning.line(layer.line, layer.name);
        ready.trace = trace_of(layer.curve, units);
        box.add(box_of(ready.trace));
        pad(14);
    }
    void operator()(const PolylineLayer& layer) {
        ready.tone = toning.line(layer.line, layer.name);
        for (const Points& run : layer.runs) box.add(run);
        pad(14);
    }
    void operator()(const PointsLayer& layer) {
        ready.tone = layer.tone;
        box.add(layer.points);
        pad(layer.labels == PointLabels::none ? 14 : 30);
    }
    void operator()(const RegionsLayer& layer) {
        ready.tone = layer.tone;
        for (const Points& outline : layer.outlines) box.add(outline);
        pad(14);
    }
    void operator()(const ControlPolygonLayer& layer) {
        ready.tone = layer.tone;
        ready.trace = trace_of(layer.curve);
        box.add(ready.trace.beziers);
        pad(16);
    }
    void operator()(const CombLayer& layer) {
        ready.tone = layer.tone;
        box.add(box_of(trace_of(layer.curve)));
        pad(14);
    }
    void operator()(const ArrowsLayer& layer) {
        ready.tone = layer.tone;
        box.add(layer.at);
        pad(arrow_length + 6);
    }
    void operator()(const TicksLayer& layer) {
        ready.tone = layer.tone;
        for (const double t : layer.at) {
            const Spot at = spot_on(layer.curve, t);
            box.add({at.data(), static_cast<std::size_t>(layer.curve.dim())});
        }
        pad(14);
    }
    void operator()(const TextLayer& layer) {
        ready.tone = layer.tone;
        box.add(layer.at);
        pad(26);
    }
    void operator()(const MapLayer& layer) {
        box.add(std::array{layer.x.front(), layer.y.front()});
        box.add(std::array{layer.x.back(), layer.y.back()});
    }
    void operator()(const ColoredPointsLayer& layer) {
        box.add(layer.points);
        pad(14);
    }
    void operator()(const SheetLayer& layer) {
        ready.tone = layer.tone;
        const Grid& nodes = layer.nodes;
        for (std::size_t i = 0; i < nodes.nu(); ++i) {
            for (std::size_t j = 0; j < nodes.nv(); ++j) {
                if (nodes.has(i, j)) box.add(std::array{nodes(i, j, 0), nodes(i, j, 1), nodes(i, j, 2)});
            }
        }
        box.add(layer.dots);
    }
};

std::vector<ReadyLayer> ready_layers(ReadyPanel& ready, Toning& toning) {
    std::vector<ReadyLayer> layers;
    const bool is_chart = ready.panel->kind == PanelKind::chart;
    const AxisUnits units = is_chart ? AxisUnits::own : AxisUnits::common;
    for (const Layer& layer : ready.panel->layers) {
        ReadyLayer& next = layers.emplace_back();
        next.layer = &layer;
        std::visit(Preparation{units, toning, next, ready.box, ready.padding}, layer);
    }
    return layers;
}

/// The ranges asked for take the place of what the layers cover.
void cut(ReadyPanel& ready) {
    for (const std::size_t k : {0u, 1u}) {
        const auto& range = k == 0 ? ready.panel->x_range : ready.panel->y_range;
        if (!range) continue;
        ready.box.sides[k] = *range;
        ready.is_cut = true;
        ready.padding = 0;
    }
}

bool alike(const ReadyPanel& a, const ReadyPanel& b) {
    return a.panel->kind == b.panel->kind && a.box.dim == b.box.dim;
}

/// Panels that share a scale share one box.
void share(std::vector<ReadyPanel>& panels) {
    std::vector<Box> boxes;
    for (const ReadyPanel& panel : panels) {
        Box& box = boxes.emplace_back();
        for (const ReadyPanel& other : panels) {
            if (alike(panel, other)) box.add(other.box);
        }
    }
    for (std::size_t i = 0; i < panels.size(); ++i) panels[i].box = boxes[i];
}

void comb(ReadyPanel& ready, const ReadyLayer& sharpest) {
    const double size = 2 * ready.box.reach();
    for (ReadyLayer& layer : ready.layers) {
        const auto* asked = std::get_if<CombLayer>(layer.layer);
        if (!asked) continue;
        const double longest = std::max(layer.peak, sharpest.peak);
        if (!asked->scale && longest == 0) continue;
        const double tooth =
            asked->scale ? *asked->scale / size : asked->share * size / (longest * size);
        layer.comb = comb_of(asked->curve, tooth, size);
        for (const Points& run : layer.comb.envelope) ready.box.add(run);
    }
}

/// Measures all combs, then makes them: those without a scale of their own on one scale where the
/// panels share theirs.
void make_combs(std::vector<ReadyPanel>& panels, PanelScale scale) {
    ReadyLayer sharpest;
    for (ReadyPanel& panel : panels) {
        const double size = 2 * panel.box.reach();
        for (ReadyLayer& layer : panel.layers) {
            const auto* asked = std::get_if<CombLayer>(layer.layer);
            if (!asked) continue;
            layer.peak = peak_curvature(asked->curve, size) / size;
            if (scale == PanelScale::shared && !asked->scale) {
                sharpest.peak = std::max(sharpest.peak, layer.peak);
            }
        }
    }
    for (ReadyPanel& panel : panels) comb(panel, sharpest);
}

/// Charts: from numbers to the axes' scales, with air where no range was asked for.
void spread_chart(ReadyPanel& ready) {
    const Panel& panel = *ready.panel;
    ready.is_log = {panel.x_scale == AxisScale::log10, panel.y_scale == AxisScale::log10, false};
    for (const std::size_t k : {0u, 1u}) {
        Interval& side = ready.box.sides[k];
        if (ready.is_log[k]) side = {std::log10(side.lo), std::log10(side.hi)};
        if (k == 0 ? panel.x_range : panel.y_range) continue;
        constexpr double largest = std::numeric_limits<double>::max();
        const double air = (k == 0 ? chart_air_x : chart_air_y) * 2 *
                           (0.5 * side.hi - 0.5 * side.lo);
        side = {std::max(side.lo - air, -largest), std::min(side.hi + air, largest)};
    }
}

}  // namespace

std::vector<ReadyPanel> prepare(const Drawing& drawing) {
    require_drawable(drawing);
    std::vector<ReadyPanel> panels;
    Toning toning;
    for (const Panel& panel : drawing.panels) {
        ReadyPanel& ready = panels.emplace_back();
        ready.panel = &panel;
        toning.next_panel();
        ready.layers = ready_layers(ready, toning);
        cut(ready);
    }
    if (drawing.scale == PanelScale::shared) share(panels);
    make_combs(panels, drawing.scale);
    for (ReadyPanel& panel : panels) cut(panel);
    if (drawing.scale == PanelScale::shared) share(panels);
    for (ReadyPanel& panel : panels) {
        if (panel.panel->kind == PanelKind::chart) spread_chart(panel);
    }
    return panels;
}

const std::string& name_of(const Layer& layer) {
    static const std::string none;
    return std::visit(
        [](const auto& any) -> const std::string& {
            if constexpr (requires { any.name; }) return any.name;
            if constexpr (requires { any.missing; }) {
                if (any.values.missing() > 0) return any.missing;
            }
            return none;
        },
        layer);
}

}  // namespace batten::drawing
