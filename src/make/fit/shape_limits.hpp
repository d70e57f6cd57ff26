#pragma once

#include <span>
#include <vector>

#include "batten/make/fit_options.hpp"
#include "make/fit/fixed_fit.hpp"

/// Fits that keep given values at their ends, rise or fall throughout, or bend one way only.
namespace batten::fitting {

/// Whether the options ask for any of it.
bool has_limits(const FitOptions& options);

/// Throws `fit.options` where limits do not go with the other options.
void require_limits(const FitOptions& options);

/// Moves the coefficients of `fixed` to the best ones within the limits; notes the directions that
/// hold with equality, which the bands need. Returns whether there are any such coefficients.
///
/// Values and slopes at the ends: coefficients fixed. Monotone and convex: differences of
/// coefficients of one sign, sufficient for the spline and for degree 1 and 2 necessary too.
/// Accuracy: 1e-10 of the largest coefficient. Cost: O(p^3).
/// Source: least distance programming [LawsonHanson1974, chapter 23]; signs of differences
/// [DeBoor2001, XI].
bool keep_within_limits(FixedFit& fixed, const FitOptions& options);

}  // namespace batten::fitting
