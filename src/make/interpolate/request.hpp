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

/// The same in two steps: what the points themselves say comes with the chords.
Request checked_but_for_chords(PointsView points, const InterpolateOptions& options);
Request with_chords(Request request, const InterpolateOptions& options);

}  // namespace batten::interpolation
