#pragma once

#include <span>
#include <vector>

namespace batten::surface_fitting {

/// Breaks with every strip halved `times` times, each new break the middle of a strip to the last
/// bit.
std::vector<double> halved(std::vector<double> breaks, int times);

/// The same, but a strip is left as it is where the used lines would not determine all splines.
std::vector<double> halved_where_determined(std::vector<double> breaks, int times, int degree,
                                            std::span<const double> used);

}  // namespace batten::surface_fitting
