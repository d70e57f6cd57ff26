#pragma once

#include <span>

#include "make/fit/tally.hpp"

namespace batten::fitting {

/// What the distances of points from a curve say, counted in samples.directions(): coordinate by
/// coordinate, or across the curve where parameters are feet. The shares are means over these; the
/// largest residual is the largest distance.
ResidualTally curve_tally(const Samples& samples, std::span<const SplineFunction> curve);

}  // namespace batten::fitting
