#pragma once

#include <span>

#include "batten/base/interval.hpp"
#include "batten/io/draw/drawing.hpp"
#include "batten/shape/spline_function.hpp"

/// How charts of splines are framed, and how they show the knots.
namespace batten::api {

/// Along which edges of a chart the knots are marked.
enum class KnotEdges { bottom, both };

/// Marks at the knots in a strip of their own beyond `content`, which with some air becomes what
/// the chart shows: the marks have one length in every chart, whatever its layers cover. A k-fold
/// knot is k marks side by side; ends are one.
void add_knot_marks(Panel& panel, const SplineFunction& spline, Interval content,
                    KnotEdges edges = KnotEdges::bottom);

/// `core`, and as much of `more` as lies within `share` of its length on either side. Never empty:
/// the extent of layers that matter, with that of layers that may be cut off.
Interval widened(Interval core, Interval more, double share);

/// The smallest and the largest of numbers, of which there is one at least.
Interval extent_of(std::span<const double> values);

}  // namespace batten::api
