#pragma once

#include "batten/base/progress.hpp"
#include "make/interpolate/hermite.hpp"
#include "make/pseudo/local_angles.hpp"

/// The pseudo-spline in space: what of it is a minimum, and what is not.
namespace batten::interpolation {

struct SpaceRule {
    double weight_exponent = 1;
    pseudo::Source source = pseudo::Source::minimiser;
    Progress progress = {};
};

/// Each tangent lies in the plane of the three points, where the rule of the plane holds; the end
/// tangents in the plane of the chord and the next tangent.
///
/// The two tangents of a chord need not lie in one plane with it. What is least, then, is the
/// energy of the planar curves through three points each, not that of the curve in space.
Tangents space_tangents(const Outline& outline, const SpaceRule& rule);

/// For each chord the magnitudes that are least where both tangents are turned into one plane, to
/// the same and to opposite sides of the chord; between these two by (1 + cos d) / 2 and
/// (1 - cos d) / 2 for the angle d between the planes. Exact where all is in a plane (d = 0, pi).
Magnitudes space_magnitudes(const Outline& outline, const Tangents& tangents,
                            const SpaceRule& rule);

}  // namespace batten::interpolation
