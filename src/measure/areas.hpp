#pragma once

#include <optional>

#include "batten/measure/area.hpp"
#include "measure/bezier/pieces.hpp"

namespace batten::bezier {

/// Throws `curve.dimension` unless the curve has `dim` coordinates.
void require_dimension(const Curve& curve, int dim);

/// `batten::area` and `batten::areas_by_winding` in normal units.
Measured area(const Pieces& pieces);
std::optional<AreasByWinding> areas_by_winding(const Pieces& pieces, double signed_area);

}  // namespace batten::bezier
