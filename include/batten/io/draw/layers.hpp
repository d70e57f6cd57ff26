#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/shape/curve.hpp"

/// What a picture is made of. Coordinates are data units, in the plane or in space; lengths that
/// only please the eye (line widths, markers, arrows) are pixels. A layer with a name appears in
/// the legend; the same name has the same colour in every panel.
namespace batten {

/// The colours of the one theme, told apart by colour-blind readers too.
enum class Tone { ink, blue, accent, teal, ochre, violet, grey };

enum class Dash { solid, dashed, dotted };

/// Without a tone, curves and polylines take the tones from ink to violet in turn.
struct LineStyle {
    std::optional<Tone> tone = {};
    Dash dash = Dash::solid;
    double width = 1.7;  ///< pixels
};

/// A curve: exact Bezier pieces where its degree is 3 or less, else chords that stay within
/// 2e-4 of its extent.
struct CurveLayer {
    Curve curve;
    std::string name = {};
    LineStyle line = {};
};

/// Straight lines through the points of each run.
struct PolylineLayer {
    std::vector<Points> runs;
    std::string name = {};
    LineStyle line = {};
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
                           ControlPolygonLayer, CombLayer, ArrowsLayer, TicksLayer, TextLayer>;

}  // namespace batten
