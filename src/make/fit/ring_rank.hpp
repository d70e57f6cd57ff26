#pragma once

#include <span>
#include <vector>

#include "make/fit/local_basis.hpp"
#include "make/fit/samples.hpp"

namespace batten::fitting {

/// What samples determine of a closed spline. Counting does not decide that: in a ring the matrix
/// may be singular though every function has a sample of its own (degree 1, an even number of
/// intervals, one sample in the middle of each).
struct RingRank {
    int rank = 0;
    std::vector<char> is_dependent;  ///< one a coefficient: on those eliminated before it
    std::vector<int> undetermined;   ///< rising
};

/// Of simple `knots` as closed_knots() makes them. By the abscissae alone, all of weight 1: what is
/// below 1e-10 after orthogonal elimination counts as nothing.
///
/// Cost: O(intervals order^3), one pass over the abscissae.
RingRank ring_rank(std::span<const double> knots, const LocalBasis& basis, const Samples& samples);

}  // namespace batten::fitting
