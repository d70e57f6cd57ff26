#pragma once

#include <optional>

#include "batten/base/points.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// A straight line through a graph by least squares.
struct GraphLine {
    double slope = 0;
    double slope_error = 0;  ///< standard error, from the scatter about the line
    double intercept = 0;
};

/// A logarithmic graph of a radius rho along a curve: rows log rho, log |rho ds / d rho|, rising
/// with the parameter. Of a log-aesthetic curve it is a line whose slope is alpha.
struct LogarithmicGraph {
    Points points{2};
    std::optional<GraphLine> line;  ///< nothing below 3 points, or where all have one abscissa
};

/// The logarithmic curvature graph [MiuraYoshidaSaito, eq. 6], from `samples` parameters spread
/// evenly over each piece, its ends left out. Where the curvature or its change is 0, or beyond a
/// double, no point exists.
///
/// Accuracy: a few ulps of the jet of order 3. Throws: `curve.dimension` below 2 dimensions.
LogarithmicGraph curvature_graph(const Curve& curve, int samples = 64);

/// The same for the radius of torsion, of a curve in space; from jets of order 4.
/// Throws: `curve.dimension` unless the curve is in space.
LogarithmicGraph torsion_graph(const Curve& curve, int samples = 64);

}  // namespace batten
