#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "batten/make/arcs.hpp"
#include "make/arcs/fewest.hpp"
#include "shape/plane.hpp"

/// What laying arcs through points and along curves has in common.
namespace batten::arc_spline {

/// Throws `option.range` and `arcs.start-twice`.
void require_sound(const ArcsOptions& options);

/// Largest radius of an arc; infinite unless asked for.
double radius_limit(const ArcsOptions& options);

/// The start tangent asked for, if one is; `chord`: from the first point to the second.
std::optional<plane::Vector> asked_start(const ArcsOptions& options, plane::Vector chord);

/// The tangent chain through `points` (closed: a ring with its first point repeated), arcs of too
/// large a radius made lines; errors 0. Throws `arcs.chord-against-start` where a chord points
/// straight back.
Row chain_row(PointsView points, plane::Vector start, double max_radius);

/// Chain and report of a row whose neighbours share their joint, to rounding. Throws
/// `number.overflow` where a centre is beyond a double.
ArcFit assembled(const Row& row, bool closed);

/// The fit of a figure that was scaled by 1 / factor, `factor` a power of two.
ArcFit scaled(const ArcFit& fit, double factor);

/// `extent`. Throws `number.overflow` where it is beyond a double.
double finite_extent(double extent);

/// The power of two by which to divide a figure of this extent so that squares of its lengths are
/// neither lost nor infinite; 1 for all usual ones.
double safe_scale(double extent);

}  // namespace batten::arc_spline
