#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/make/densify.hpp"

/// Which points a cell's polynomial runs through, and at which parameters.
namespace batten::lagrange {

constexpr int highest_degree = 15;

/// `degree` + 1 points from `first` on; on a ring `first` may be negative, and the last beyond it.
struct Window {
    std::ptrdiff_t first = 0;
    int degree = 1;
};

/// The rule that gives each cell, and each point, its window.
struct Windows {
    std::ptrdiff_t points = 0;
    int degree = 3;
    int end_degree = 3;
    bool closed = false;

    std::ptrdiff_t cells() const { return closed ? points : points - 1; }
    /// For the cell from point k to point k + 1.
    Window of_cell(std::ptrdiff_t k) const;
    /// For the polynomial centred at point k, which passes the points on both its sides.
    Window of_point(std::ptrdiff_t k) const;

private:
    Window placed(std::ptrdiff_t k, bool at_end, int lean) const;
    std::ptrdiff_t last_start(int m) const { return points - 1 - m; }
};

/// The parameters of the points; of a ring one more, the end of the period.
///
/// Throws `points.not-finite`, `points.repeated`, `lagrange.parameter-count`,
/// `lagrange.parameters-not-increasing`.
std::vector<double> parameters_of(PointsView points, const DensifyOptions& options);

/// Distances from each point to the next, closed also from the last to the first, each to the
/// power 1 or 1/2 and summed from 0.
std::vector<double> cumulative(PointsView points, LagrangeParameter parameter, bool closed);

/// How one window makes a cell's curve, whatever the points are.
///
/// With s = 0 ... 1 over the cell from P to Q, the curve is P + s (Q - P) - s (1 - s) g(s), and g,
/// of degree m - 2, takes the values (P_i - P - x_i (Q - P)) / (x_i (x_i - 1)) at the other
/// points' places x_i. The matrix turns P_i - P - x_i (Q - P) into the power coefficients of g.
struct Recipe {
    int terms = 0;  ///< of g: degree - 1; what lies beyond in the arrays is not set
    std::array<int, highest_degree> other;     ///< the other points, counted from the cell's start
    std::array<double, highest_degree> place;  ///< x_i
    std::array<double, highest_degree * highest_degree> matrix;  ///< [term * terms + i]
};

/// The recipe for a window whose point `cell` (counted from its first) starts the cell; `nodes`:
/// the parameters of the window's points, rising.
Recipe recipe_of(std::span<const double> nodes, int cell);

}  // namespace batten::lagrange
