#pragma once

#include <optional>

#include "batten/shape/piecewise_cubic.hpp"
#include "make/interpolate/hermite.hpp"

namespace batten::interpolation {

/// The natural spline by chords in the plane, in few passes over the memory; the bits of
/// `cubic_spline`. Nothing in other dimensions, and where chords are so short or long that the
/// parameters must be looked at one by one.
std::optional<PiecewiseCubic> plain_natural_curve(const Outline& outline);

}  // namespace batten::interpolation
