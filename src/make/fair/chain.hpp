#pragma once

#include <optional>
#include <vector>

#include "batten/shape/log_aesthetic.hpp"
#include "make/fair/track.hpp"

namespace batten::fairing {

/// A chain of log-aesthetic arcs along fair points.
struct Chain {
    LogAestheticCurve curve;
    double error = 0;  ///< largest distance of a point from the chain
};

/// Few arcs, joined with equal directions and curvatures, from which no point is further than
/// `tolerance`; through the points `ends` among others. More joints are taken, each time at the
/// worst point of every arc that is too far, until they are all points.
Chain chain_along(const Track& track, double alpha, const std::vector<std::size_t>& ends,
                  double tolerance);

}  // namespace batten::fairing
