#pragma once

#include <vector>

#include "batten/measure/measured.hpp"
#include "measure/bezier/panel.hpp"

namespace batten::bezier {

/// The length of each piece of the curve, in normal units. The bounds on the errors add up to
/// `tolerance` (in normal units), or to rounding if that is more.
std::vector<Measured> lengths(const Motion& motion, double tolerance);

/// Sum of the parts, compensated; errors add up.
Measured total(const std::vector<Measured>& parts);

/// int r ds over the whole curve, in normal units, with an error of `tolerance` times the length.
std::vector<double> first_moment(const Motion& motion, double tolerance);

}  // namespace batten::bezier
