#pragma once

#include <optional>
#include <span>

#include "batten/base/points.hpp"
#include "shape/plane.hpp"

/// Arcs through points, each leaving its point in the direction in which the one before arrived.
///
/// Everything here is about consecutive points that differ, in the plane.
namespace batten::arc_spline {

/// Bulges of the chain that leaves the first point along `tangent` (a unit vector) and passes
/// through all `points`; returns the unit tangent at the last one. `bulges` has a place for each
/// arc. A bulge is beyond 1 where the chord points back (more than half a circle) and infinite
/// where it points straight back: no such arc exists.
///
/// Law: an error of the start's angle reaches every joint undiminished, with alternating sign:
/// tau[k + 1] = 2 phi[k] - tau[k], phi the direction of the chord.
/// Cost: one square root and two divisions an arc.
/// Source: [Nakajima, section 5], free of slopes: the tangent is reflected in the chord.
plane::Vector tangent_chain(PointsView points, plane::Vector tangent, std::span<double> bulges);

/// The start tangent (a unit vector) that minimises the sum of (kappa[k + 1] - kappa[k])^2 over
/// the chain, with `closed` also over its seam. Along the chord for two points, the circle's for
/// three.
///
/// With the start turned by x each curvature is A cos x + B sin x, so the sum is a quadratic form
/// in (cos x, sin x): the minimum is the global one, in closed form.
plane::Vector smoothest_start(PointsView points, bool closed);

/// The start tangent of a chain that closes smoothly, if there is one without an arc of more than
/// half a circle. `ring`: the polygon with its first point repeated at the end.
///
/// An odd number of chords closes for two opposite tangents; an even number only where the
/// alternating sum of the chords' directions is 0 modulo 180 degrees, then for any tangent (the
/// smoothest is taken).
std::optional<plane::Vector> closing_start(PointsView ring);

/// The steepest of the chain's arcs: the largest |bulge|.
double steepest(std::span<const double> bulges);

}  // namespace batten::arc_spline
