#pragma once

#include <array>
#include <vector>

#include "make/fit_surface/cloud.hpp"
#include "make/fit_surface/nodes.hpp"
#include "num/symmetric.hpp"

namespace batten::surface_fitting {

/// Full knot vectors, of x and of y.
using KnotPair = std::array<std::vector<double>, 2>;

/// Knot vectors whose inner, simple knots have been moved.
struct MovedLines {
    KnotPair knots;
    int moved = 0;  ///< knot lines that could move
    int steps = 0;
    bool is_converged = true;
    double last_gain = 0;  ///< of the last step, a share of delta2
};

/// Moves all simple inner knot lines of both directions to lessen delta2; the coefficients are
/// always the best ones. Lines do not cross, and strips stay determined by the data.
///
/// The derivative by a knot t_l is exact: with t_l once more among the knots of the M_i,
/// dS/dt_l = sum for i = l-k+1 ... l of (c_{i-1} - c_i) / (t_{i+k-1} - t_i) M_i, k the order.
/// Second derivatives are Kaufman's approximation; on a grid the two directions do not mix in them.
/// A local minimum; degree 0 stays as it is.
/// Cost: a step is one fit and, for L lines of p x q coefficients, L^2 p q operations.
/// Source: [GolubPereyra1973], Levenberg-Marquardt.
MovedLines move_lines(const Nodes& nodes, KnotPair knots, int degree);
MovedLines move_lines(const Cloud& cloud, KnotPair knots, int degree);

/// The local model of delta2 / 2 by some knots, which it does not mix with the others.
struct KnotModel {
    struct Knot {
        std::size_t side, index;  ///< 0: of x, 1: of y; where it stands in the knot vector
    };
    std::vector<Knot> knots;
    std::vector<double> gradient;
    num::SymmetricMatrix normal{0};
};

/// A fit whose knot lines may move: delta2 and what it does nearby, as functions of the lines.
class MovableLines {
public:
    virtual ~MovableLines() = default;
    virtual const KnotPair& knots() const = 0;
    /// With the best coefficients; infinite where the data do not determine them.
    virtual double delta2() const = 0;
    virtual std::vector<KnotModel> models() const = 0;
    /// Takes these lines if delta2 is less with them.
    virtual bool improves_by(KnotPair knots) = 0;
};

/// The descent of all that can move.
MovedLines descend(MovableLines& lines, int degree);

/// Indices of the inner knots that stand alone.
std::vector<std::size_t> simple_knots(const std::vector<double>& t, int degree);

}  // namespace batten::surface_fitting
