#pragma once

#include <vector>

#include "surface_sets.hpp"

namespace papers {

/// KPROG 3: each inner knot line in turn is moved to where delta2 is least between its neighbours,
/// `sweeps` times.
batten::SurfaceFit with_moved_lines(const SurfaceSet& set, const batten::SurfaceFit& start,
                                    int sweeps);

}  // namespace papers
