#pragma once

#include <optional>
#include <span>
#include <vector>

#include "batten/shape/log_aesthetic.hpp"

namespace batten::spiral {

/// Points in the plane by the chords between them, without corners inside.
struct SplineRun {
    std::vector<double> lengths;               ///< of the chords; closed: as many as points
    std::vector<double> directions;            ///< of the chords, radians
    std::vector<std::optional<double>> fixed;  ///< tangents, radians: one a point, or none
    bool closed = false;
};

/// One arc a chord.
struct SplineChain {
    std::vector<double> angles;  ///< of the tangents where the arcs start
    std::vector<LogAestheticSegment> segments;
    bool converged = false;
    int steps = 0;
    /// Largest jump of the curvature at points with free tangents, times the shorter chord beside.
    double jump = 0;
    std::size_t held = 0;          ///< tangents kept at 137 degrees to a chord: the curvature jumps
    std::size_t other_alphas = 0;  ///< arcs whose alpha is not the one asked for
};

/// Tangents for which the curvature has no jump at any point whose tangent is free, and is 0 at
/// free ends: the spline of G2 log-aesthetic arcs.
///
/// Accuracy: jump <= 1e-12 where converged; else the best tangents found. Always arcs that meet
/// their points. Cost: 0.7 us a point for alpha = -1.
/// Source: Newton's method on the tangents, each arc's own two unknowns eliminated; tridiagonal,
/// steps halved until the sum of the squared jumps falls [LevienSequin2009].
SplineChain log_aesthetic_spline(const SplineRun& run, double alpha);

}  // namespace batten::spiral
