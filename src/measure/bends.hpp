#pragma once

#include <optional>
#include <vector>

#include "batten/measure/curvature.hpp"
#include "measure/bezier/panel.hpp"

namespace batten::bezier {

/// `batten::max_curvature`, `turning` and `inflections`; the results are in data units.
std::optional<MaxCurvature> max_curvature(const Motion& motion);
double turning(const Motion& motion);
std::vector<double> inflections(const Motion& motion);

/// Whether the curve turns back at a point, a cusp or a fold: there the turning's sign is a
/// convention.
bool turns_back(const Motion& motion);

}  // namespace batten::bezier
