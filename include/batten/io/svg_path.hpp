#pragma once

#include <string>
#include <string_view>

#include "batten/shape/curve.hpp"

namespace batten {

/// A plane curve as SVG path data: one line or cubic Bezier piece for each piece of the curve (an
/// `ArcChain` as svg_arcs.hpp has it), in data coordinates (y up), numbers in their shortest exact
/// form; `Z` where it is closed.
///
/// Accuracy: control points within 2 ulps of the coordinates' size; joints exact. The speed along
/// the curve is not written. Throws `curve.dimension` unless there are two coordinates,
/// `curve.not-exact` unless every piece is a polynomial of degree 3 or less, `number.overflow`
/// where a control point is beyond a double.
std::string svg_path(const Curve& curve);

/// An SVG picture of nothing but the curve, drawn with y up; its path data is svg_path(curve), or
/// those of the parts between jumps.
std::string svg_picture(const Curve& curve);

/// The curve that SVG path data describes (M L H V C S Q T A Z, in both cases) [SVG2, chapter 9].
///
/// Segment i runs over [i, i + 1]; segments of no length are left out. Closed where the data end
/// in Z. Lines and Bezier segments give a PiecewiseCubic; a path with an elliptic arc a rational
/// cubic B-spline, in which arcs are exact but for rounding.
///
/// Throws `svg.path` at the first character that cannot be read, `svg.subpaths` where a second
/// part starts, `number.overflow`.
Curve parse_svg_path(std::string_view data, const std::string& place);

/// The data of the first path element of an SVG picture; no transform is applied. Throws
/// `svg.no-path`.
std::string_view first_svg_path(std::string_view picture, const std::string& place);

}  // namespace batten
