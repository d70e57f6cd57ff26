#pragma once

#include "batten/shape/log_aesthetic.hpp"
#include "make/interpolate/build.hpp"

namespace batten::interpolation {

/// One log-aesthetic arc a span, G2 where no tangent is given and no corner is.
Built log_aesthetic(const Outline& outline, double alpha);

/// The arcs between joints `from` and `to` of `curve`, from arc length 0.
LogAestheticCurve between_joints(const LogAestheticCurve& curve, IndexRange part);

}  // namespace batten::interpolation
