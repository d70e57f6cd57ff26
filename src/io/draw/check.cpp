#include "io/draw/check.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "io/draw/shapes/trace.hpp"

namespace batten::drawing {
namespace {

/// The checks of one layer; `place` says which.
struct Inspector {
    const Panel& panel;
    std::string place;
    std::optional<int> dim = {};

    bool has_log() const {
        return panel.x_scale == AxisScale::log10 || panel.y_scale == AxisScale::log10;
    }

    void require_linear() const {
        if (!has_log()) return;
        throw Error("drawing.option", place, "a logarithmic axis",
                    "only points, polylines, regions and texts can be drawn there");
    }

    void inspect_dim(int found) {
        require_plane_or_space(found, place);
        const bool is_chart = panel.kind == PanelKind::chart;
        const bool is_relief = panel.kind == PanelKind::relief;
        if ((is_chart && found == 3) || (is_relief && found == 2) || (dim && *dim != found)) {
            throw Error("drawing.dimension", place, std::to_string(found) + " coordinates",
                        is_chart    ? "a chart is drawn in 2 coordinates"
                        : is_relief ? "a relief is drawn in 3 coordinates"
                                    : "all layers of a panel must have as many coordinates");
        }
        dim = found;
    }

    void inspect(PointsView points) {
        if (points.empty()) return;
        inspect_dim(points.dim());
        try {
            require_finite(points);
        } catch (const Error& error) {
            throw error.at(place + " " + error.place());
        }
        for (std::size_t i = 0; i < points.size() && has_log(); ++i) {
            for (int k = 0; k < 2; ++k) {
                const AxisScale scale = k == 0 ? panel.x_scale : panel.y_scale;
                if (scale == AxisScale::linear || points(i, k) > 0) continue;
                throw Error("drawing.not-positive", place + " point " + std::to_string(i),
                            format_number(points(i, k)),
                            "a logarithmic axis shows numbers above 0 only");
            }
        }
    }

    void inspect(const Curve& curve) {
        require_linear();
        inspect_dim(curve.dim());
    }

    void operator()(const CurveLayer& layer) { inspect(layer.curve); }
    void operator()(const PolylineLayer& layer) {
        for (const Points& run : layer.runs) inspect(run);
    }
    void operator()(const PointsLayer& layer) {
        inspect(layer.points);
        for (const int i : layer.corners) {
            if (i >= 0 && static_cast<std::size_t>(i) < layer.points.size()) continue;
            throw Error("drawing.option", place + " corners", std::to_string(i),
                        "a corner must be one of the points, counted from 0");
        }
    }
    void operator()(const RegionsLayer& layer) {
        for (const Points& outline : layer.outlines) inspect(outline);
    }
    void operator()(const ControlPolygonLayer& layer) {
        inspect(layer.curve);
        if (!is_cubic(layer.curve)) {
            throw Error("drawing.no-control-points", place, "not polynomials of degree 3 or less",
                        "a control polygon needs Bezier pieces");
        }
    }
    void operator()(const CombLayer& layer) {
        inspect(layer.curve);
        if (!(layer.share > 0 && layer.share <= 1)) {
            throw Error("drawing.option", place + " share", format_number(layer.share),
                        "must be above 0 and at most 1");
        }
        if (layer.scale && !std::isfinite(*layer.scale)) {
            throw Error("drawing.option", place + " scale", format_number(*layer.scale),
                        "must be finite");
        }
    }
    void operator()(const ArrowsLayer& layer) {
        require_linear();
        inspect(layer.at);
        inspect(layer.directions);
        if (layer.at.size() != layer.directions.size()) {
            throw Error("drawing.option", place + " directions",
                        std::to_string(layer.directions.size()),
                        "as many directions as points are needed");
        }
    }
    void operator()(const TicksLayer& layer) {
        inspect(layer.curve);
        for (const double t : layer.at) {
            if (layer.curve.domain().contains(t)) continue;
            throw Error("drawing.option", place + " ticks", format_number(t),
                        "a tick must lie in the curve's domain");
        }
    }
    void operator()(const TextLayer& layer) {
        inspect(PointsView(layer.at.data(), 1, static_cast<int>(layer.at.size())));
    }

    [[noreturn]] void refuse(const char* what, std::string found, const char* rule) const {
        throw Error("drawing.option", place + what, std::move(found), rule);
    }

    void require_color_range(const std::optional<Interval>& range) const {
        const bool is_good = !range || (std::isfinite(range->lo) && std::isfinite(range->hi) &&
                                        range->lo < range->hi);
        if (is_good) return;
        refuse(" range", format_number(range->lo) + "," + format_number(range->hi),
               "must be finite and rising");
    }

    void operator()(const ColoredPointsLayer& layer) {
        inspect_dim(2);
        inspect(layer.points);
        if (layer.points.size() == 0 || layer.values.size() != layer.points.size()) {
            refuse(" values", std::to_string(layer.values.size()) + " for " +
                   std::to_string(layer.points.size()) + " points",
                   "as many numbers as points are needed, at least one");
        }
        require_finite(PointsView(layer.values.data(), layer.values.size(), 1));
        require_color_range(layer.range);
    }

    void operator()(const MapLayer& layer) {
        require_linear();
        inspect_dim(2);
        const Grid& z = layer.values;
        if (layer.x.size() < 2 || layer.y.size() < 2 || z.nu() != layer.x.size() ||
            z.nv() != layer.y.size() || z.dim() != 1) {
            refuse(" map", std::to_string(z.nu()) + " x " + std::to_string(z.nv()),
                   "two places or more a side, and as many numbers as nodes");
        }
        for (const auto* places : {&layer.x, &layer.y}) {
            require_finite(PointsView(places->data(), places->size(), 1));
            for (std::size_t i = 1; i < places->size(); ++i) {
                if (!((*places)[i] > (*places)[i - 1])) {
                    refuse(" map", format_number((*places)[i]), "places must rise");
                }
            }
        }
        require_finite(PointsView(z.view().values().data(), z.nu() * z.nv(), 1));
        require_color_range(layer.range);
        if (z.missing() == z.nu() * z.nv()) refuse(" map", "no nodes", "a node must be there");
    }

    void operator()(const SheetLayer& layer) {
        const Grid& nodes = layer.nodes;
        if (nodes.nu() < 2 || nodes.nv() < 2 || nodes.dim() != 3 ||
            nodes.missing() == nodes.nu() * nodes.nv()) {
            refuse(" sheet", std::to_string(nodes.nu()) + " x " + std::to_string(nodes.nv()),
                   "two nodes of 3 coordinates or more a side, one of them there");
        }
        inspect(PointsView(nodes.view().values().data(), nodes.nu() * nodes.nv(), 3));
        inspect(layer.dots);
        for (const SheetLine& line : layer.lines) {
            for (std::size_t i = 0; i < line.places.size(); ++i) {
                const double u = line.places(i, 0), v = line.places(i, 1);
                const bool is_on = u >= 0 && u <= static_cast<double>(nodes.nu() - 1) && v >= 0 &&
                                   v <= static_cast<double>(nodes.nv() - 1);
                if (!is_on) {
                    refuse(" line", format_number(u) + "," + format_number(v),
                           "a line upon a sheet must stay on it");
                }
            }
        }
    }
};

void require_range(const Panel& panel, const std::string& place) {
    for (const bool is_x : {true, false}) {
        const std::optional<Interval>& range = is_x ? panel.x_range : panel.y_range;
        const AxisScale scale = is_x ? panel.x_scale : panel.y_scale;
        if (!range) continue;
        const bool finite = std::isfinite(range->lo) && std::isfinite(range->hi);
        if (!finite || !(range->lo < range->hi) ||
            (scale == AxisScale::log10 && !(range->lo > 0))) {
            throw Error("drawing.option", place + (is_x ? " x range" : " y range"),
                        format_number(range->lo) + "," + format_number(range->hi),
                        "must be finite and rising, and above 0 on a logarithmic axis");
        }
    }
}

}  // namespace

void require_plane_or_space(int dim, const std::string& place) {
    if (dim == 2 || dim == 3) return;
    throw Error("drawing.dimension", place, std::to_string(dim) + " coordinates",
                "what is drawn must have 2 or 3 coordinates");
}

void require_drawable(const Drawing& drawing) {
    constexpr int narrowest = 240, widest = 100000;
    if (drawing.width < narrowest || drawing.width > widest) {
        throw Error("drawing.option", "width", std::to_string(drawing.width),
                    "must be from 240 to 100000 pixels");
    }
    if (drawing.columns && *drawing.columns < 1) {
        throw Error("drawing.option", "columns", std::to_string(*drawing.columns),
                    "must be at least 1");
    }
    if (drawing.panels.empty()) {
        throw Error("drawing.empty", "drawing", "no panels", "there must be something to show");
    }
    for (std::size_t i = 0; i < drawing.panels.size(); ++i) {
        const Panel& panel = drawing.panels[i];
        const std::string place = "panel " + std::to_string(i);
        require_range(panel, place);
        Inspector inspector{panel, place};
        if (inspector.has_log() && panel.kind != PanelKind::chart) {
            throw Error("drawing.option", place, "a logarithmic axis",
                        "is for charts only");
        }
        for (std::size_t j = 0; j < panel.layers.size(); ++j) {
            inspector.place = place + " layer " + std::to_string(j);
            std::visit(inspector, panel.layers[j]);
        }
        if (inspector.dim == 3 && (panel.x_range || panel.y_range)) {
            throw Error("drawing.option", place, "a range", "ranges are for the plane");
        }
        if (!inspector.dim) {
            throw Error("drawing.empty", place, "nothing", "there must be something to show");
        }
    }
}

}  // namespace batten::drawing
