#pragma once

#include <span>

namespace batten::knots {

/// Throws `curve.breaks` unless there are at least two finite, strictly increasing breaks.
void require_breaks(std::span<const double> breaks);

}  // namespace batten::knots
