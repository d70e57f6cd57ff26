#pragma once

#include "batten/base/interval.hpp"

namespace batten::surfaces {

/// Throws `surface.outside` unless `domain` contains `part`.
void require_inside(Interval domain, Interval part, const char* axis);

}  // namespace batten::surfaces
