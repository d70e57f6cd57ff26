#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "batten/base/points.hpp"
#include "make/arcs/biarc.hpp"
#include "make/arcs/tangents.hpp"

/// The fewest arcs that pass given points within a tolerance.
namespace batten::arc_spline {

/// Arcs in a row and, for each, how far what it stands for is from it.
struct Row {
    std::vector<Arc> arcs;
    std::vector<double> errors;
};

struct PointTask {
    PointsView points;  ///< consecutive ones differ
    bool closed = false;
    double tolerance = 0;  ///< data units
    double max_radius = std::numeric_limits<double>::infinity();
};

/// Biarcs from one of the points to another, tangents from the proposals, that pass all points in
/// between within the tolerance and in their order; the fewest moves (a biarc counts 2, or 1 where
/// one arc does). Nothing where not even neighbours can be joined.
///
/// Points are passed in order where the places nearest to them never fall back by more than 4
/// tolerances and never run ahead by more than pi/2 times the points' distance and 4 tolerances.
///
/// Up to 300 points the minimum over all choices of points and tangents; closed: over those that
/// start at point 0 or at one other point. Beyond 300 only the furthest-reaching partial rows of
/// each count are kept, and far targets are tried at growing steps.
/// Cost: O(n^2) biarcs up to 300 points; beyond, a constant number for each move.
std::optional<Row> fewest_biarcs(const PointTask& task, const Tangents& tangents);

/// A biarc between each point and the next by the first tangent proposed; a line where none
/// exists. The errors are 0: the points are met.
Row neighbour_biarcs(const PointTask& task, const Tangents& tangents);

}  // namespace batten::arc_spline
