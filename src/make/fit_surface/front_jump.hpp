#pragma once

#include "make/fit_surface/front_model.hpp"

namespace batten::surface_fitting {

/// The lines that run together make a jump: the order of a cubic.
constexpr int jump_lines = 4;

/// The parameters with the bundle of one front, of four lines, run together: the surface jumps
/// across it. delta2 does not change while such a line moves between two nodes, and the derivative
/// by its place is zero; so it is placed by turns: every node beside it goes to the side that fits
/// it better, and phi through the cells between.
std::vector<double> jump_at(const Nodes& nodes, const FrontShape& shape,
                            std::vector<double> theta, int front);

}  // namespace batten::surface_fitting
