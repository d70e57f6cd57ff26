#pragma once

#include "make/fair/plane_fair.hpp"

namespace batten::fairing {

/// Fairing for waves of so many points that their fourth derivatives are lost to rounding: some
/// hundred points of a fair track stand for all, each with the mean displacement of the data around
/// it; the change that they make is spread over the others by cubic interpolation.
///
/// `fine` is what the points themselves allow.
PlaneResult faired_coarsely(const PlaneGoal& goal, const PlaneWish& wish, const PlaneResult& fine);

}  // namespace batten::fairing
