#pragma once

#include "make/fit/knot_descent.hpp"

/// Out of local minima: knots taken out here and put in there.
namespace batten::fitting {

/// The best of all local minima next to `set` with one knot more: three places in every gap are
/// ranked by one linear fit each, the best few refined.
Descent with_one_more(FreeFit& fit, const KnotSet& set, int refined);

/// Takes every knot out in turn and puts one in where it helps most, as long as that gains.
Descent exchange(FreeFit& fit, Descent start);

}  // namespace batten::fitting
