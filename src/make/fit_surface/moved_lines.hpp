#pragma once

#include <vector>

#include "make/fit_surface/nodes.hpp"

namespace batten::surface_fitting {

/// Knot vectors whose inner, simple knots have been moved.
struct MovedLines {
    std::vector<double> x_knots, y_knots;
    int moved = 0;  ///< knot lines that could move
    int steps = 0;
    bool is_converged = true;
};

/// Moves all simple inner knot lines of both directions to lessen delta2; the coefficients are
/// always the best ones. Lines do not cross, and strips stay determined by the nodes.
///
/// The derivative by a knot t_l is exact: with t_l once more among the knots of the M_i,
/// dS/dt_l = sum for i = l-k+1 ... l of (c_{i-1} - c_i) / (t_{i+k-1} - t_i) M_i, k the order. In
/// Kaufman's approximation the two directions do not mix. A local minimum; degree 0 stays as it is.
/// Cost: a step is one fit and, for L lines of p x q coefficients, L^2 p q operations.
/// Source: [GolubPereyra1973], Levenberg-Marquardt.
MovedLines move_lines(const Nodes& nodes, std::vector<double> x_knots, std::vector<double> y_knots,
                      int degree);

}  // namespace batten::surface_fitting
