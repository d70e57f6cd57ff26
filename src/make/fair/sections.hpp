#pragma once

#include <cstddef>
#include <vector>

#include "make/fair/track.hpp"

namespace batten::fairing {

/// The points where the curvature of a fair track changes its sign or turns round, rising; of a
/// row also both ends. Bumps below a fiftieth of the curvature's range do not count.
std::vector<std::size_t> section_ends(const Track& track);

/// The points from one section end to the next one (of a ring across the seam).
Track part_of(const Track& track, std::size_t from, std::size_t to);

}  // namespace batten::fairing
