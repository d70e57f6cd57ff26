#pragma once

#include "batten/make/fair.hpp"

namespace batten::fairing {

/// `fair` for points in space.
Fairing fair_in_space(PointsView points, const FairOptions& options);

}  // namespace batten::fairing
