#pragma once

#include <string>
#include <vector>

#include "batten/make/interpolate.hpp"
#include "make/interpolate/hermite.hpp"

namespace batten::interpolation {

/// What was asked for, found to make sense.
struct Request {
    Outline outline;  ///< borrows the points
    std::vector<std::string> notes;
};

/// Throws what `interpolate` says, but for what the parameters of a spline and the x of pchip and
/// makima break. A closed curve's last point that repeats the first is left out, with a note.
Request checked(PointsView points, const InterpolateOptions& options);

}  // namespace batten::interpolation
