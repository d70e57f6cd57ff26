#pragma once

#include <optional>

#include "make/fair/space_fair.hpp"

namespace batten::fairing {

/// The points of the one log-aesthetic arc in space (rho^alpha and mu^beta linear in arc length)
/// that is nearest to the data, at the arc lengths of `smooth`; nothing where none was found.
///
/// Unknown are the start, its frame and the four radii at the ends; residuals are those across the
/// arc, and the mean one along it, without which the arc would slide along itself. At most 100 of
/// the points are looked at. Cost: 2 ms. Source: Levenberg-Marquardt, columns scaled [More1978].
std::optional<SpaceTrack> arc_along(const SpaceGoal& goal, const SpaceTrack& smooth);

}  // namespace batten::fairing
