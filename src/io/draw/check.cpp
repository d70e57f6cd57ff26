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
        if ((is_chart && found == 3) || (dim && *dim != found)) {
            throw Error("drawing.dimension", place, std::to_string(found) + " coordinates",
                        is_chart ? "a chart is drawn in 2 coordinates"
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
        if (inspector.has_log() && panel.kind == PanelKind::geometry) {
            throw Error("drawing.option", place, "a logarithmic axis",
                        "geometry has equal units on all axes");
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
