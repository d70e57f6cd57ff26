#pragma once

#include "make/fit/knot_choice.hpp"

namespace batten::fitting {

/// Knots inserted as ever, then taken out, moved, stacked and put in one at a time as long as the
/// criterion falls (see Pruning); and places where the value or the slope alone is broken, each one
/// coefficient. The same from a few equal intervals, to which breaks are added first; the better
/// counts.
///
/// Where the data jump or bend sharply, breaks stand there and the knots go. A local minimum.
/// Cost: some ten fits a knot for each of some ten sweeps, each O(p order^3) whatever N; with
/// breaks, each O(p (order + breaks)^2).
KnotChoice pruned_knots(const Samples& samples, const LocalBasis& basis,
                        const FitOptions& options);

}  // namespace batten::fitting
