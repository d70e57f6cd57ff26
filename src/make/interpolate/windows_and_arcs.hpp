#pragma once

#include "make/interpolate/build.hpp"

namespace batten::interpolation {

/// Lagrange's polynomials of this degree (at most 3) over moving windows, with index parameters
/// or those given; of a lower degree where there are too few points. Tangent jumps and spans that
/// were tamed are noted. Throws what `densify` throws.
Built lagrange_windows(const Outline& outline, const InterpolateOptions& options, int degree);

/// One circular arc from point to point, tangents joined. The status is not_met where a closed
/// chain does not close. Throws what `arcs` throws.
Built joined_arcs(const Outline& outline);

}  // namespace batten::interpolation
