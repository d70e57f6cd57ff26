#pragma once

#include "make/fit/knot_choice.hpp"
#include "make/fit/site_fit.hpp"

namespace batten::fitting {

/// Knots inserted as ever, then taken out, moved, stacked and put in one at a time as long as the
/// criterion falls (see Pruning); and places where the value or the slope alone is broken, each one
/// coefficient. The same from a few equal intervals, to which breaks are added first; the better
/// counts.
///
/// Curves of several coordinates and closed splines have knots alone.
/// Where the data jump or bend sharply, breaks stand there and the knots go. A local minimum.
/// Cost: some ten fits a knot for each of some ten sweeps, each O(p order^3) whatever N; with
/// breaks, each O(p (order + breaks)^2).
KnotChoice pruned_knots(const Samples& samples, const LocalBasis& basis,
                        const FitOptions& options);

/// Corners and jumps are there whatever the data are: the reader is told where. Of curves, whose
/// knots go on moving with the parameters, at the very end.
void note_breaks(KnotChoice& choice, const BrokenSites& sites, int order);

/// Knots alone, where a full vector has any inside `range`.
BrokenSites sites_of(std::span<const double> knots, Interval range);

}  // namespace batten::fitting
