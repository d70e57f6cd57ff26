#pragma once

#include <vector>

#include "batten/shape/curved_knot_surface.hpp"
#include "make/fit_surface/nodes.hpp"

namespace batten::surface_fitting {

/// Which lines there are.
struct FrontShape {
    Rectangle domain;
    int bundle = 5;           ///< lines along the front
    int front_intervals = 3;  ///< of phi
    int y_strips = 3;
    std::vector<SplineFunction> given = {};  ///< lines that stand still, in place of a bundle

    int front_values() const { return front_intervals + 3; }
    /// Those of phi, logarithms of the gaps, logits of the two lines beside.
    int parameters() const { return given.empty() ? front_values() + bundle - 1 + 2 : 0; }
    int lines() const { return given.empty() ? bundle + 2 : static_cast<int>(given.size()); }
    int x_functions() const { return lines() + 4; }
    int y_functions() const { return y_strips + 3; }
    int coefficients() const { return x_functions() * y_functions(); }
};

/// The lines at one y and their derivatives by the parameters, lines() x parameters().
struct LinesAt {
    std::vector<double> x;
    std::vector<double> slopes;
    bool is_inside = true;  ///< in order, within the domain
};

LinesAt lines_at(const FrontShape& shape, const std::vector<double>& theta, double y);

/// The best coefficients for given lines, what is left, and the local model of descent.
struct FrontState {
    double delta2 = 0;  ///< infinite where lines leave the domain
    std::vector<double> coefficients;
    std::vector<double> gradient, normal;  ///< of delta2 / 2 by theta; Kaufman's J^T J
};

enum class Slopes { none, wanted };
FrontState front_state(const Nodes& nodes, const FrontShape& shape,
                       const std::vector<double>& theta, Slopes slopes);

CurvedKnotSurface front_surface(const FrontShape& shape, const std::vector<double>& theta,
                                const std::vector<double>& coefficients);

/// The parameters that put a bundle of total width `width` along `front`: x at every y-line.
std::vector<double> front_start(const FrontShape& shape, const Nodes& nodes,
                                const std::vector<double>& front, double width);

/// Where the heights rise or fall most, row by row: the path through all rows with the largest sum
/// of smoothed differences, sudden sideways steps charged.
/// Source: dynamic programming [Viterbi1967].
std::vector<double> steepest_path(const Nodes& nodes);

}  // namespace batten::surface_fitting
