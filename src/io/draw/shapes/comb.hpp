#pragma once

#include <vector>

#include "batten/base/points.hpp"
#include "batten/shape/curve.hpp"

namespace batten::drawing {

/// A curvature comb in data units.
struct Comb {
    Points teeth;                 ///< two rows a tooth: on the curve, then the tip
    std::vector<Points> envelope;  ///< through the tips; a new run where the comb breaks
};

/// The comb whose teeth are `tooth` (data units) long where the curvature is 1 / size. Teeth stand
/// evenly on each stretch without a break, one at both of its ends: size / 100 apart, which is
/// measured half way between the curve and the tips so that they also fill a sharp bend.
Comb comb_of(const Curve& curve, double tooth, double size);

}  // namespace batten::drawing
