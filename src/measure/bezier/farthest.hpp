#pragma once

#include <vector>

#include "batten/base/points.hpp"
#include "measure/bezier/feet.hpp"

namespace batten::bezier {

/// The place of one curve that is farthest from something else.
struct Farthest {
    std::size_t piece = 0;
    double u = 0;
    double distance = 0;  ///< reached there, in the curve's normal units
    double error = 0;     ///< no place is farther than distance + error
};

/// From all of `a` to curve `b`, whose pieces are in units of their own.
Farthest farthest(const Pieces& a, const Pieces& b, double tolerance);

/// From all of `a` to the nearest of points of the data.
Farthest farthest(const Pieces& a, PointsView points, double tolerance);

}  // namespace batten::bezier
