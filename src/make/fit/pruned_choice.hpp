#pragma once

#include "make/fit/free_fit.hpp"
#include "make/fit/knot_choice.hpp"

namespace batten::fitting {

/// Knots inserted as ever, then taken out, moved, stacked and put in one at a time as long as the
/// criterion bic falls. On the functions of docs/fitting.md the mean squared error is less so than
/// where a knot is charged as more than one parameter.
///
/// Where the data jump or bend sharply, knots stack up there and the others go. A local minimum.
/// Cost: some ten fits a knot for each of some ten sweeps, each O(p order^3) whatever N.
KnotChoice pruned_knots(const Samples& samples, const LocalBasis& basis,
                        const FitOptions& options);

/// Stacked knots are corners and jumps, whatever the data are: the reader is told where. Of curves,
/// whose knots go on moving with the parameters, at the very end.
void note_stacks(KnotChoice& choice, const KnotSet& set, int order);

}  // namespace batten::fitting
