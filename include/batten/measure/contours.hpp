#pragma once

#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/interval.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/shape/curve.hpp"
#include "batten/shape/surface.hpp"

namespace batten {

/// One line of equal height. It runs with the higher ground on its left, so that it goes round
/// hills counter-clockwise.
struct Contour {
    double level = 0;
    Curve curve;  ///< cubic pieces, the parameter is the length of their chords
    Status status = Status::met;  ///< not_met where a piece may be beyond the tolerance
};

/// All lines where S(x, y) = level, traced on the spline: from border to border or closed.
///
/// Aim:    no point of a line farther than `tolerance` (relative: of the larger side of the domain)
///         from the level; joints and directions there exact. Where that is not reached, or how
///         lines connect is not certain (20000 quarterings do not tell), the status says so.
/// Lines do not cross. Their topology is that of a lattice, 8 cells a knot interval and 64 a side at
/// least, whose cells are quartered where an edge is crossed twice, a line turns by a right angle or
/// heights between may be level; seen by second differences, then by Bezier ordinates of the cubic
/// through 4 x 4 heights. Islands smaller than an eighth of a cell can be missed.
/// The lattice follows curved knot lines (of both directions: those of y); a line stays with the
/// function of its own cell, so that fronts are sharp. Where the surface jumps at a level the line
/// runs along the jump, as exact as the joints there are close.
/// Where the surface is flat at the level, the border of what is above.
/// Cost:   one evaluation of the lattice and about 10 values a joint.
/// Throws: `surface.degree` for degree 0, `number.overflow`.
/// Source: marching squares [LorensenCline1987], each crossing found on the spline itself; ordinates
///         that bound a polynomial [Farouki2012].
std::vector<Contour> contours(const Surface& surface, double level,
                              Tolerance tolerance = relative(1e-6));

/// `count` round levels inside the range of the surface on a lattice.
std::vector<double> round_levels(const Surface& surface, int count);

/// The same inside of a range of heights.
std::vector<double> round_levels(Interval heights, int count);

}  // namespace batten
