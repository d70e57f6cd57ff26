#pragma once

#include "make/fit_surface/front_lines.hpp"

namespace batten::surface_fitting {

/// The best coefficients for given lines, what is left, and the local model of descent.
struct FrontState {
    double delta2 = 0;  ///< infinite where lines leave the domain or their nodes
    std::vector<double> coefficients;
    std::vector<double> gradient, normal;  ///< of delta2 / 2 by theta; Kaufman's J^T J
};

enum class Slopes { none, wanted };
FrontState front_state(const Nodes& nodes, const FrontShape& shape,
                       const std::vector<double>& theta, Slopes slopes);

}  // namespace batten::surface_fitting
