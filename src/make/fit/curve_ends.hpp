#pragma once

#include "batten/base/points.hpp"
#include "batten/make/fit_options.hpp"
#include "make/fit/fixed_fit.hpp"

namespace batten::fitting {

/// What a parametric curve must keep at its ends. Empty: free.
struct CurveEnds {
    std::vector<double> start_point, end_point;
    std::vector<double> start_tangent, end_tangent;  ///< unit vectors
};

bool has_curve_ends(const FitOptions& options);

/// Throws `fit.options` with closed curves, `fit.tangent` unless a tangent is finite, not 0 and of as
/// many coordinates as the points.
CurveEnds curve_ends(PointsView points, const FitOptions& options);

/// Moves the coefficients to those of the least delta2 that keep the ends; false where there are too
/// few to keep all. Nothing is done where the data leave coefficients open. Open splines.
/// `directions`: in which a coefficient counts as a parameter (see Samples), and so does what holds it.
///
/// Cost: O(coefficients) for each pair of conditions.
bool hold_ends(FixedFit& fixed, const CurveEnds& ends, int directions);

/// Whether the curve leaves and arrives along its tangents, and not against them.
bool goes_along(std::span<const SplineFunction> curve, const CurveEnds& ends);

}  // namespace batten::fitting
