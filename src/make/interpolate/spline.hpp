#pragma once

#include <vector>

#include "batten/make/interpolate.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "make/interpolate/chords.hpp"

namespace batten::interpolation {

/// What happens at the two ends of an open spline. The derivatives, dim numbers each, are those of
/// clamped ends; empty, they are the first and last chord over their parameter step.
struct SplineEnds {
    Ends rule = Ends::natural;
    std::vector<double> first_derivative;
    std::vector<double> last_derivative;
};

/// One parameter a point (closed: one more), from 0, by chords.
///
/// Centripetal steps are longest x sqrt(length / longest), so that they scale as lengths do.
/// Throws `number.overflow` where a chord is shorter than 2^-480 or the sum longer than 2^480
/// (coefficients hold its third power), `interpolate.parameters` where a chord is so short
/// beside the others that the sum does not grow.
/// Source: [LeeETY1989] for the centripetal exponent.
std::vector<double> parameters_by(Parameter rule, const Chords& chords);

/// The C2 cubic spline through points at `parameters`; closed: periodic, one parameter more than
/// points. At least two points, parameters strictly increasing.
///
/// Accuracy: backward stable; with equal slopes on both sides of every point exactly straight.
/// Laws: (1) through the points, bit for bit
///       (2) points (and parameters) x 2^k give a result x 2^k, exactly
/// Cost: O(n), no allocation but the result; about 14 ns a planar point.
/// Source: the equations for the second derivatives [DeBoor2001, IV(5)]; three points and
/// not-a-knot: the parabola.
PiecewiseCubic cubic_spline(PointsView points, std::vector<double> parameters,
                            const SplineEnds& ends);
PiecewiseCubic periodic_spline(PointsView points, std::vector<double> parameters);

}  // namespace batten::interpolation
