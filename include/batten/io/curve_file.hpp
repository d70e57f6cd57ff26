#pragma once

#include <string>
#include <vector>

#include "batten/base/value.hpp"
#include "batten/io/files.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// The tree of a `batten.curve/1` file, as docs/formats.md describes it: every number of the curve,
/// exact.
///
/// Piecewise cubics, B-splines, graphs of splines with jumps, log-aesthetic curves and chains of
/// arcs keep their kind; any other
/// curve whose pieces are polynomials of degree 3 or less is written as piecewise cubics by its
/// derivatives at the starts of the pieces.
/// Throws `curve.not-exact` for all others, `number.overflow` where a coefficient is beyond a
/// double. `name` is free text for people.
///
/// Law: curve_of(curve_value(c)) is c, bit for bit.
Value curve_value(const Curve& curve, const std::string& name = {});

/// The curve that such a tree describes; `place` is what errors call it. Entries it does not know
/// are ignored.
///
/// Throws `curve.format`, `curve.kind`, `curve.entry` (an entry is missing or of the wrong type or
/// size), `curve.breaks`, and what BSplineBasis, BSplineCurve, SplineFunction and ArcChain throw.
Curve curve_of(const Value& tree, const std::string& place);

/// The curve in `source`: a `batten.curve/1` file, the first path of an SVG picture, or bare SVG
/// path data. Pure. Throws what parse_json, curve_of and parse_svg_path throw; `svg.no-path`;
/// `curve.several` where the file holds more than one;
/// `file.empty`; `curve.format` where it is none of the three.
Curve parse_curve(const Source& source);

/// All curves of such a tree, at least one: that of a `batten.curve/1` tree, or those of a
/// `batten.curves/1` or `batten.contours/1` tree in their order. Throws what curve_of throws.
std::vector<Curve> curves_of(const Value& tree, const std::string& place);

/// The tree of a `batten.curves/1` file. Throws what curve_value throws.
Value curves_value(const std::vector<Curve>& curves);

/// All curves in `source`. Throws what parse_curve throws, but for `curve.several`.
std::vector<Curve> parse_curves(const Source& source);

/// The one of `curves`; throws `curve.several` where they are more, with `place`.
const Curve& one_curve(const std::vector<Curve>& curves, const std::string& place);

/// The curve in a file (`-` is standard input).
Curve read_curve(const std::string& path);

/// Whether parse_curve is the reader for this source, rather than parse_table.
bool holds_curve(const Source& source);

}  // namespace batten
