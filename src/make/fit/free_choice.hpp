#pragma once

#include <functional>
#include <optional>

#include "make/fit/free_fit.hpp"
#include "make/fit/knot_choice.hpp"

namespace batten::fitting {

/// Knots moved to where they serve best (KPROG = 3).
///
/// Without `free_from`: the best set of m knots is grown from that of m - 1 by one insertion and
/// then by exchanges, so few local minima hold it; the rule chooses m, every knot charged as two
/// parameters. With it, as in the paper: insertion until delta2 is below, from then on every
/// insertion is followed by Levenberg steps of all knots.
KnotChoice free_knots(const Samples& samples, const LocalBasis& basis, const FitOptions& options);

/// The first of the best sets of 0, 1, ... knots that is accepted; nothing where none of up to
/// `most` knots is.
std::optional<KnotSet> fewest_free(FreeFit& fit, int most,
                                   const std::function<bool(const KnotSet&)>& is_accepted);

/// The same number of knots moved on from where `choice` has them, for samples that have changed a
/// little.
std::vector<double> moved_on(const Samples& samples, const LocalBasis& basis,
                             const std::vector<double>& knots, const FitOptions& options);

}  // namespace batten::fitting
