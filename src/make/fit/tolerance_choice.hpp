#pragma once

#include <functional>

#include "make/fit/fixed_fit.hpp"
#include "make/fit/knot_choice.hpp"

namespace batten::fitting {

/// Moves a solved spline to where it keeps what it must; false where it cannot.
using Limit = std::function<bool(FixedFit&)>;

/// Few knots, with no residual above options.tolerance, `limit` kept by every spline tried.
///
/// Intervals with a residual above the tolerance are cut at their middle sample until there is none.
/// Then knots are taken out, the one with the least jump of the highest derivative first, as long as
/// all residuals stay within; then one at a time, with the others moved to where delta2 is least
/// (open splines of degree 1 and more, 40 knots at most). Where 17 or fewer are left for up to 4,096
/// samples, the best sets of 0, 1, ... knots are tried last. A local minimum of the number of knots:
/// nothing says that no other set is smaller. Cost: one pass over the samples for every knot tried.
KnotChoice knots_within(const Samples& samples, const LocalBasis& basis,
                        const FitOptions& options, const Limit& limit);

}  // namespace batten::fitting
