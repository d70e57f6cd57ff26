#pragma once

#include <functional>
#include <vector>

#include "batten/make/fit_statistics.hpp"
#include "make/fit_surface/axis.hpp"
#include "make/fit_surface/nodes.hpp"

namespace batten::surface_fitting {

/// The coefficients for one pair of knot vectors.
struct Solution {
    std::vector<double> coefficients;
    int iterations = 0;
    bool is_converged = true;
};

/// Solves the normal equations. Full grids: (A^T A)^-1 in each direction, and one correction by
/// the residuals where weights or knots are so uneven that it matters and it is asked for; where
/// they are more uneven still, orthogonal reduction. Else conjugate gradients, preconditioned by the
/// same.
///
/// Source: corrected seminormal equations [Bjorck1987]; [HestenesStiefel1952].
enum class Corrected { no, where_needed };
Solution solve(const Nodes& nodes, const Axis& x, const Axis& y, Corrected corrected);

/// c -> A^T W A c.
using NormalMatrix = std::function<std::vector<double>(const std::vector<double>& c)>;
/// Conjugate gradients on A^T W A c = g, preconditioned by the full grid's inverse, until the
/// energy norm has fallen by `iterated_accuracy`, or so many steps are made (0: as it takes).
Solution conjugate_gradients(std::vector<double> g, const NormalMatrix& matrix, const Axis& x,
                             const Axis& y, int steps = 0);

/// Whether the solution of a full grid needs no correction.
bool is_harmless(const Axis& x, const Axis& y);

/// ((Ax^T Ax)^-1 x (Ay^T Ay)^-1) g.
std::vector<double> inverted(std::vector<double> g, const Axis& x, const Axis& y);

/// What the residuals of a solution say.
struct Misfit {
    double delta2 = 0;
    Psi psi{};
    double max_residual = 0;
    std::vector<double> x_strips, y_strips;  ///< the rule's measure of every strip
    bool psi_is_missing = false;             ///< the nodes were not read
};

/// One pass over the nodes; strips are measured where `rule` is given.
Misfit misfit(const Nodes& nodes, const Axis& x, const Axis& y, const std::vector<double>& c,
              std::optional<StripRule> rule);

/// z - S at all nodes, data units (0 where there is none).
std::vector<double> residuals(const Nodes& nodes, const Axis& x, const Axis& y,
                              const std::vector<double>& c);

/// Coefficients in whose support no node counts, as i, j.
std::vector<std::array<int, 2>> open_coefficients(const Nodes& nodes, const Axis& x, const Axis& y);
/// The same from the square sums of their splines at the nodes.
std::vector<std::array<int, 2>> open_coefficients(const std::vector<double>& present, const Axis& x,
                                                  const Axis& y);

}  // namespace batten::surface_fitting
