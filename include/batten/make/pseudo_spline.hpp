#pragma once

#include <span>

#include "batten/base/points.hpp"
#include "batten/base/progress.hpp"
#include "batten/shape/piecewise_cubic.hpp"

namespace batten {

struct PseudoSplineOptions {
    bool closed = false;
    double weight_exponent = 1;  ///< see docs/interpolation.md
    Progress progress = {};
};

/// A pseudo-spline and what the tables know of it, in data units.
struct PseudoSpline {
    PiecewiseCubic curve;
    double length = 0;
    double area = 0;  ///< counter-clockwise positive; an open curve is closed by its chord
    double pseudo_energy = 0;
};

/// The curve that `interpolate` makes by the method pseudo-spline, bit for bit, through many points
/// of the plane (n rows, 2 columns) in one pass, with its length and area but without the other
/// measures.
///
/// Breaks:   0, 1, 2, ...
/// Laws:     points x 2^k give a result x 2^k, exactly.
/// Accuracy: length 1e-9, area 1e-8, pseudo-energy 1e-12, each relative to the sum of its parts'
///           magnitudes: from tables, no quadrature [InoueShibata, eq. 15 to 20].
/// Cost:     0.12 us a point, 0.17 us where turns go up to 100 degrees, linear in n; memory for
///           the curve and one number a point.
/// Throws:   as `interpolate`; `number.overflow` unless all chords are between 2^-480 and 2^480.
PseudoSpline pseudo_spline(PointsView points, const PseudoSplineOptions& options = {});

/// The same numbers without a curve.
struct PseudoSplineMeasures {
    double length = 0;
    double area = 0;
    double pseudo_energy = 0;
};

/// As above, into the caller's memory: the power coefficients of the cubics over u = t - i as
/// PiecewiseCubic::power takes them, 8 numbers for each of the joints (one more than spans).
/// Throws `curve.coefficients` where `block` is not as long as that.
PseudoSplineMeasures pseudo_spline(PointsView points, const PseudoSplineOptions& options,
                                   std::span<double> block);

}  // namespace batten
