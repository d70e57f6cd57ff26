#pragma once

#include <vector>

#include "make/fit_surface/nodes.hpp"

namespace batten::surface_fitting {

/// Where the heights rise or fall most, row by row: the path through all rows with the largest sum
/// of smoothed differences, sudden sideways steps charged. What lies beside a `known` path, x at
/// every y-line, is not looked at.
/// Source: dynamic programming [Viterbi1967].
std::vector<double> steepest_path(const Nodes& nodes,
                                  const std::vector<std::vector<double>>& known = {});

}  // namespace batten::surface_fitting
