#pragma once

#include "batten/make/interpolate.hpp"

namespace batten::interpolation {

/// Fills the measured numbers of a report; adds a note for each that does not exist.
void add_measures(const Curve& curve, InterpolateReport& report);

/// The direction of a plane curve at each of its joints, in (-pi, pi], leaving (at the end of an
/// open curve: arriving) or arriving (at its start: leaving). Where the speed is zero, the limit.
enum class Side { leaving, arriving };
std::vector<double> joint_angles(const Curve& curve, Side side);

}  // namespace batten::interpolation
