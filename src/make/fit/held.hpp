#pragma once

#include <span>

#include "make/fit/fixed_fit.hpp"

namespace batten::fitting {

/// Moves the coefficients to the best ones without these jumps, each at a knot that stands often
/// enough to have it; they count as fixed. Open splines of one side whose coefficients are all
/// determined.
///
/// Cost: O(held^2 p).
void hold_smooth(FixedFit& fixed, std::span<const HeldDerivative> held);

}  // namespace batten::fitting
