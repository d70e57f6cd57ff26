#pragma once

#include <vector>

#include "batten/measure/continuity.hpp"
#include "measure/bezier/pieces.hpp"

namespace batten::bezier {

/// `batten::continuity`.
std::vector<Joint> continuity(const Pieces& pieces);

}  // namespace batten::bezier
