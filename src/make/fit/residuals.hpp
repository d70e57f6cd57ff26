#pragma once

#include <span>
#include <vector>

#include "batten/shape/spline_function.hpp"
#include "make/fit/fixed_fit.hpp"

/// What is left of samples by a spline, whatever the number of their coordinates.
namespace batten::fitting {

/// One spline a coordinate.
std::vector<SplineFunction> splines_of(const FixedFit& fixed, std::size_t sides);

/// One number a sample, data units: y - S(x) with its sign, or the distance of a point from the
/// curve's at the same parameter.
std::vector<double> residuals_of(const Samples& samples, std::span<const SplineFunction> splines);

/// The weighted sum of their squares.
double delta2_of(const Samples& samples, std::span<const double> residuals);

}  // namespace batten::fitting
