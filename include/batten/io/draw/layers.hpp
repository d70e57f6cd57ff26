#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/io/draw/styles.hpp"
#include "batten/io/draw/surface_layers.hpp"
#include "batten/shape/curve.hpp"

/// What a picture is made of. Coordinates are data units, in the plane or in space; lengths that
/// only please the eye (line widths, markers, arrows) are pixels. A layer with a name appears in
/// the legend; the same name has the same colour in every panel.
namespace batten {

/// A curve: exact Bezier pieces where its degree is 3 or less, else chords that stay within
/// 2e-4 of its extent.
struct CurveLayer {
    Curve curve;
    std::string name = {};
    LineStyle line = {};
    std::string label = {};  ///< written upon the curve where that is long enough and there is room
};

/// Straight lines through the points of each run.
struct PolylineLayer {
    std::vector<Points> runs;
    std::string name = {};
    LineStyle line = {};
    std::string label = {};  ///< written upon each run that is long enough, where there is room
};

enum class Marker { open, closed };
enum class PointLabels { none, index };

/// Dots. They shrink where they are dense; a dot that hides behind another is left out, and so is
/// a label that would cross another.
struct PointsLayer {
    Points points;
    std::string name = {};
    Marker marker = Marker::open;
    std::vector<int> corners = {};  ///< rows drawn as a filled square instead
    PointLabels labels = PointLabels::none;
    Tone tone = Tone::ink;
};

/// Closed outlines, filled in a pale tone.
struct RegionsLayer {
    std::vector<Points> outlines;
    std::string name = {};
    Tone tone = Tone::blue;
};

/// The Bezier control polygon of each piece. Throws `drawing.no-control-points` where the curve is
/// not made of polynomials of degree 3 or less.
struct ControlPolygonLayer {
    Curve curve;
    std::string name = {};
    Tone tone = Tone::grey;
};

/// Teeth normal to the curve, as long as the curvature there is large, on the outer side of the
/// bend; and the line through their tips. Both break where the direction or the curvature jumps.
/// A tooth that would be longer than the picture, as at a cusp, is left out.
struct CombLayer {
    Curve curve;
    std::string name = {};
    /// Length of a tooth per curvature (data units squared). Without it the longest tooth takes
    /// the `share` of the picture's extent; panels that share their scale share this too.
    std::optional<double> scale = {};
    double share = 0.16;
    Tone tone = Tone::accent;
};

/// Arrows of one length in the picture; a zero direction draws none.
struct ArrowsLayer {
    Points at;
    Points directions;
    std::string name = {};
    Tone tone = Tone::blue;
};

/// The tangents of `curve` at the parameters `t`.
ArrowsLayer tangent_arrows(const Curve& curve, std::span<const double> t);

/// Short marks across a curve at the parameters `at`.
struct TicksLayer {
    Curve curve;
    std::vector<double> at;
    std::string name = {};
    Tone tone = Tone::blue;
};

/// A short text beside a point.
struct TextLayer {
    std::vector<double> at;
    std::string text;
    Tone tone = Tone::ink;
};

using Layer = std::variant<CurveLayer, PolylineLayer, PointsLayer, RegionsLayer,
                           ControlPolygonLayer, CombLayer, ArrowsLayer, TicksLayer, TextLayer,
                           MapLayer, ColoredPointsLayer, SheetLayer>;

}  // namespace batten
