#pragma once

#include "batten/api/operation.hpp"
#include "batten/make/fit.hpp"

namespace batten {

/// What the operation `fit` makes of a fit whose samples are not there any more, such as that of
/// chunks: the graph (nothing where the spline has jumps), the spline with its covariance and the
/// report.
Outcome outcome_of(Fit made);

}  // namespace batten
