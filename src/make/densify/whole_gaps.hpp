#pragma once

#include <cstddef>
#include <vector>

namespace batten::lagrange {

/// `gaps` whole numbers, none below 1, that add up to the number of cells and follow the density:
/// for each cell its share of a gap, so that a gap is long where the density is low.
///
/// The gaps themselves are rounded, not the places where they end: they change by one now and
/// then, where rounded places would make them change to and fro, which the index parameter does
/// not forgive.
std::vector<std::size_t> whole_gaps(const std::vector<double>& density, std::size_t gaps);

}  // namespace batten::lagrange
