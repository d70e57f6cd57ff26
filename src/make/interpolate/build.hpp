#pragma once

#include <string>
#include <vector>

#include "batten/make/interpolate.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "make/interpolate/request.hpp"

namespace batten::interpolation {

/// A curve through points and what became of the search for it.
struct Built {
    Curve curve;
    Status status = Status::met;
    std::vector<std::string> notes;
};

/// The curve asked for, whole.
Built built(const Request& request, const InterpolateOptions& options);

/// The pieces between joints `from` and `to` of `curve`, unchanged.
PiecewiseCubic between_joints(const PiecewiseCubic& curve, IndexRange part);

}  // namespace batten::interpolation
