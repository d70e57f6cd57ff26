#pragma once

#include <vector>

#include "make/fair/track.hpp"

namespace batten::fairing {

/// Where a point goes between its neighbours.
enum class Foot {
    middle,  ///< of its neighbours, as in the paper: all chords become equal
    kept,    ///< where its own chords' ratio puts it: the spacing stays
};

struct FilterPlan {
    double alpha = -1;
    int sweeps = 250;
    int window = 9;         ///< samples on each side
    Foot foot = Foot::middle;
    double bound = 0;       ///< no point moves further; 0: no bound
    std::vector<char> split;  ///< points that stay and that no window crosses, or none
};

struct FilterResult {
    Track track;
    int sweeps = 0;
    double last_move = 0;  ///< largest move of the last sweep, over the mean edge
};

/// The discrete filter: each inner point goes where its curvature is that of the local least-squares
/// line of rho^alpha over arc length.
///
/// Where the paper is silent: curvature is signed and a window's sign is that of its sum; samples
/// are clamped to 0.2 ... 5 times the window's mean |kappa|; windows are cut at ends and splits and
/// need 3 samples; points move one after another (Gauss-Seidel); a line value <= 0 moves nothing;
/// ends stay. Cost: 0.08 us a point and sweep at window 5.
/// Source: [MiuraYoshidaSaito, eq. 3, 7, 8], whose equation for the step is linear:
/// phi = kappa l^2 / 8; for Foot::kept the sagitta of the circle at the foot.
FilterResult filtered(const Track& data, const FilterPlan& plan);

/// How far rho^alpha is from a line in arc length: the root mean squared residual of one
/// least-squares line over all inner points, over the mean's magnitude.
double linearity_residual(const Track& track, double alpha);
/// The same from arc lengths and curvatures.
double linearity_residual(const std::vector<double>& s, const std::vector<double>& kappa,
                          double alpha);

}  // namespace batten::fairing
