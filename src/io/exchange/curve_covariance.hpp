#pragma once

#include "batten/make/fit_bands.hpp"
#include "io/exchange/entries.hpp"

/// How sure a fit is of its curve, as part of the curve's file.
namespace batten::exchange {

/// Every number of it, exact.
Value covariance_value(const FitCovariance& covariance);

/// What stands under `fit`. Throws `curve.entry` and what SplineFunction throws.
FitCovariance covariance_in(const Entries& curve);

}  // namespace batten::exchange
