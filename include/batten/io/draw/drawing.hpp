#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/io/draw/layers.hpp"

namespace batten {

enum class PanelKind {
    geometry,  ///< a plane or space figure with equal units along all axes
    chart,     ///< y against x, each axis with its own unit
    relief,    ///< heights z over x and y in space, each axis with its own unit
};

enum class AxisScale { linear, log10 };

enum class AxesStyle { shown, hidden };

/// One picture with its axes. Layers lie over one another in the order they were added.
///
/// Geometry in space is seen from above the front right (isometric: all three axes are shortened
/// alike), inside its box, with its shadow on the floor.
struct Panel {
    std::string caption;
    PanelKind kind = PanelKind::geometry;
    std::string x_label;
    std::string y_label;
    std::string z_label;  ///< in space, where names not given are x, y and z
    AxisScale x_scale = AxisScale::linear;  ///< log10: charts only, not for curves and arrows
    AxisScale y_scale = AxisScale::linear;
    /// The part to show (in the plane); what lies outside is cut off. Without it everything is
    /// shown.
    std::optional<Interval> x_range;
    std::optional<Interval> y_range;
    AxesStyle axes = AxesStyle::shown;
    std::vector<Layer> layers;

    Panel& add(Layer layer) {
        layers.push_back(std::move(layer));
        return *this;
    }
};

/// Whether the panels show the same part of the plane at the same scale, or each its own.
enum class PanelScale { own, shared };

/// A picture: panels side by side under one title and one legend.
struct Drawing {
    std::string title;
    std::string subtitle;
    std::string description;  ///< for readers who cannot see it; made from the content if empty
    std::vector<Panel> panels = std::vector<Panel>(1);
    std::optional<int> columns;  ///< panels in a row; without it 3 at most
    PanelScale scale = PanelScale::own;
    int width = 800;  ///< pixels, at least 240

    /// Adds a layer to the last panel.
    Drawing& add(Layer layer) {
        panels.back().add(std::move(layer));
        return *this;
    }
};

/// The drawing as an SVG document: the same bytes on every system whose mathematical library
/// agrees to the hundredth of a pixel.
///
/// Any finite coordinates are drawn, also where they differ by a few ulps or nearly overflow;
/// numbers along the axes are then given without a power of ten or an offset, which is noted.
/// Throws `drawing.empty` where a panel shows nothing, `drawing.dimension` unless all layers of a
/// panel are in the plane or all in space, `drawing.option` for options without a meaning,
/// `drawing.not-positive` for numbers at or below 0 on a logarithmic axis,
/// `drawing.no-control-points`, `points.not-finite`, `number.overflow`.
/// Cost: linear in the points and pieces; strokes and dots closer than can be seen are merged.
std::string svg(const Drawing& drawing);

/// A chart of the curvature against the arc length: signed in the plane (left turns positive),
/// its magnitude in space. The line breaks where the curvature jumps.
///
/// Accuracy: 1e-3 of the picture, arc length to 1e-6 on smooth pieces. Throws `drawing.dimension`,
/// `drawing.not-finite`, `number.overflow`.
/// Source: Gauss-Legendre, 8 nodes between samples [DLMF, 3.5(v)].
Panel curvature_plot(const Curve& curve, const std::string& name = {});

/// A chart of the logarithmic curvature graph of a curve, with its least-squares line; the caption
/// gives the slope and its standard error. Throws `curve.dimension`.
Panel curvature_graph_plot(const Curve& curve, const std::string& name = {});

/// The same of the radius of torsion. Throws `curve.dimension` but for curves in space.
Panel torsion_graph_plot(const Curve& curve, const std::string& name = {});

}  // namespace batten
