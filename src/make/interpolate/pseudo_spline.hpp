#pragma once

#include "batten/make/interpolate.hpp"
#include "make/interpolate/build.hpp"
#include "make/interpolate/hermite.hpp"

namespace batten::interpolation {

/// The curve of [InoueShibata]: each tangent from three points, then the magnitudes of each chord
/// that make E L^2 least. In the plane, or in space as `space_tangents` says.
Built pseudo_spline(const Outline& outline, const InterpolateOptions& options);

/// All tangents together make the sum of E L^2 least; in the plane.
Built pseudo_spline_global(const Outline& outline, const InterpolateOptions& options);

}  // namespace batten::interpolation
