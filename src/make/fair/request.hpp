#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batten/make/fair.hpp"
#include "make/fair/track.hpp"

namespace batten::fairing {

/// What was asked for, found to make sense, in working units: the first point at 0, the extent
/// between 1 and 2. Scaling by powers of 2 is exact.
struct Request {
    Track data;
    std::vector<double> z;  ///< of points in space
    double unit = 1;       ///< one working unit in data units
    double sigma = 0;      ///< working units
    double bound = 0;      ///< working units; 0: none
    std::optional<double> lambda;
    std::size_t held_ends = 0;
    bool is_straight = false;
    std::vector<std::string> notes;
};

/// Throws what `fair` says, but for `fair.folds`.
Request checked(PointsView points, const FairOptions& options);

/// A lambda of working units; nothing where it is beyond a double.
std::optional<double> in_data_units(double lambda, const Request& request);

}  // namespace batten::fairing
