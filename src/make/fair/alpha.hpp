#pragma once

#include "make/fair/track.hpp"

namespace batten::fairing {

/// An alpha and its standard error.
struct AlphaEstimate {
    double alpha = 0;
    double error = 0;   ///< infinite where nothing could be told
    double sigma = 0;   ///< of the noise, from what is left over
    int steps = 0;
    bool converged = false;
};

/// Beyond this error an alpha says nothing.
constexpr double identifiable_error = 0.5;

/// The alpha of one arc without inflection or extremum of curvature, by maximum likelihood: the
/// points are an arc's at known arc lengths, plus noise across it.
///
/// Unknown are start, direction, both radii and alpha. One row holds the mean displacement along
/// the arc at 0: without it an arc can slide along itself, with another alpha. Arc lengths are
/// those of the data smoothed to waves of 60 points. The error is that of the inverse normal matrix
/// times the scatter. At least 8 points.
/// Cost: 0.4 to 0.7 ms for 100 points. Source: Levenberg-Marquardt, columns scaled [More1978].
AlphaEstimate most_likely_alpha(const Track& arc);

}  // namespace batten::fairing
