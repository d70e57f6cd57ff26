#pragma once

#include <span>
#include <vector>

#include "batten/base/points.hpp"
#include "make/fit/knot_system.hpp"

namespace batten::fitting {

/// Factors of sigma, inf for every sample that stands alone: more than 10 sigma off the line
/// through its two neighbours, and 5 times as far as any three of the three samples on either side
/// (at the ends of an open row fewer) are off theirs. Empty where there is none.
///
/// Such a sample bends every coarse fit so far that its neighbours look worse than it does, and
/// knots are drawn to it. A jump or a peak of two samples stands alone nowhere. Where sigma is not
/// known it is taken from the median of all.
/// Cost: O(N), and O(N log N) where sigma is not known.
std::vector<double> isolated_factors(const Samples& samples);

/// The same of points in order, by their distances from the stretch between their neighbours.
/// `sigma`: one a point, or empty where not known.
std::vector<double> isolated_factors(PointsView points, Ends ends, std::span<const double> sigma);

}  // namespace batten::fitting
