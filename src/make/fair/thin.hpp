#pragma once

#include <cstddef>
#include <vector>

#include "make/fair/plane_fair.hpp"

namespace batten::fairing {

/// Whether some points are much closer together than the others: fourth derivatives over the short
/// edges would drown all else.
bool is_crowded(const Track& track);

/// Fairing of a crowded track: points at least a fifth of the median edge apart are made fair, the
/// others are put on the cubics between these, by their share of the arc length, and keep of their
/// distance from the cubics of the data what lambda leaves of waves of two edges.
PlaneResult faired_thinly(const PlaneGoal& goal, const PlaneWish& wish);

}  // namespace batten::fairing
