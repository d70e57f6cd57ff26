#pragma once

#include "batten/base/points.hpp"

namespace batten {

/// An alpha found from points.
struct FoundAlpha {
    double alpha = 0;
    double error = 0;             ///< standard error; infinite where nothing could be told
    bool identifiable = false;    ///< whether the error is at most 0.5
};

/// The alpha of one arc, without inflection or extremum of curvature, by maximum likelihood from
/// noisy points (n rows, 2 columns).
///
/// Unbiased, the stated error within 0.9 to 1.3 of the true one up to 0.1 % noise of the length
/// for 100 points over 90 degrees. Cost: 0.6 to 2.5 ms for 100 points.
/// Throws: `points.dimension`, `points.too-few` below 8, `points.not-finite`, `points.repeated`.
FoundAlpha alpha_of(PointsView points);

/// The paper's way: the slope of the logarithmic curvature graph of a cubic least-squares B-spline
/// with `inner_knots` equal intervals but one. Biased by 0.06 to 0.35 without any noise, and of no
/// use from 0.01 % noise on: for comparison. Throws as above, and what `fit` throws.
/// Source: [MiuraYoshidaSaito, section 3.3].
FoundAlpha alpha_by_graph(PointsView points, int inner_knots = 4);

}  // namespace batten
