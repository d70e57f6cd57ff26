#pragma once

#include "batten/shape/bspline.hpp"
#include "make/fit/fixed_fit.hpp"

namespace batten::fitting {

/// The curve whose coordinates are the sides of a fit.
BSplineCurve curve_of(const FixedFit& fixed);

}  // namespace batten::fitting
