#pragma once

#include "batten/make/pseudo_spline.hpp"
#include "make/interpolate/hermite.hpp"

namespace batten::interpolation {

/// Whether no square of a chord's length leaves the range of a double or loses digits.
bool has_safe_chords(const Outline& outline);

/// The pseudo-spline of an outline in the plane without corners or fixed tangents, from tables.
/// Requires: safe chords; 8 numbers a joint in `block`.
PseudoSplineMeasures pseudo_pass(const Outline& outline, const PseudoSplineOptions& options,
                                 std::span<double> block);
PseudoSpline pseudo_pass(const Outline& outline, const PseudoSplineOptions& options);

}  // namespace batten::interpolation
