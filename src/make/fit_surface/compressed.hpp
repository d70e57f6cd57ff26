#pragma once

#include <memory>
#include <vector>

#include "make/fit_surface/solve.hpp"

namespace batten::surface_fitting {

/// A full grid read once: what fits over halved strips need, without the nodes.
///
/// Splines over strips made by halving lie in the space over the finest strips of that kind. For
/// its splines F_i(x), F_j(y) three products of the weighted heights are kept, with both, with the
/// F_j alone (a row an x-line) and with the F_i alone.
///
/// delta2 is that of the finest strips and the distance to their fit, so that nothing cancels.
/// Accuracy: 1e-10 of delta2. Cost: about two passes over the nodes; a fit then takes
///         order (M + N) operations a spline.
class Compressed {
public:
    /// Nothing where the nodes do not determine the splines over so many strips.
    static std::unique_ptr<Compressed> of(const Nodes& nodes, int degree, int strips);

    /// Whether all breaks are borders of the finest strips.
    bool holds(const std::vector<double>& x_breaks, const std::vector<double>& y_breaks) const;

    /// Coefficients, delta2 and the projected rule's measure of every strip; psi stays empty.
    void fit(const Axis& x, const Axis& y, Solution& solution, Misfit& misfit) const;

private:
    Compressed(const Nodes& nodes, Axis x, Axis y);

    const Nodes& nodes_;
    Axis x_, y_;
    std::vector<double> both_;  ///< x functions by y functions
    std::vector<double> rows_;  ///< x-lines by y functions
    std::vector<double> columns_;  ///< y-lines by x functions
    std::vector<double> finest_;  ///< coefficients
    double finest_delta2_ = 0;
};

}  // namespace batten::surface_fitting
