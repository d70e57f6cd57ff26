#pragma once

#include <span>
#include <vector>

#include "batten/make/fit_surface.hpp"

namespace batten::surface_fitting {

/// What a surface fit works on: heights on a grid and their weights, 1 / sigma.
struct Nodes {
    std::span<const double> x, y;
    std::span<const double> z;                 ///< x slowest; missing ones are 0
    std::vector<double> x_weight, y_weight;    ///< the weight of node (r, s) is their product
    std::vector<double> cell_factor_sq;        ///< times the root of this; empty: 1 everywhere
    std::size_t count = 0;                     ///< nodes with a height and a weight
    std::size_t missing = 0;
    bool sigma_known = false;
    SigmaSource source = SigmaSource::estimated;
    std::optional<double> sigma;               ///< where it is one number
    double least_delta2 = 0;                   ///< what rounding leaves, where errors are estimated
    std::vector<double> filled;                ///< owns z where nodes are missing

    bool is_full() const { return cell_factor_sq.empty(); }
    /// Whether any node of row r (column s) counts.
    std::vector<double> used_x() const;
    std::vector<double> used_y() const;

    Nodes() = default;
    Nodes(Nodes&&) = default;
    Nodes& operator=(Nodes&&) = default;
};

/// Throws `points.not-finite` at the first height that is none. Asked only where a result is not
/// finite: one that is not spoils all sums.
void require_finite_heights(const Nodes& nodes);

/// Checks everything that `fit_surface` promises to check about the samples but their heights.
Nodes prepared_nodes(const SurfaceSamples& samples, const FitSurfaceOptions& options);

}  // namespace batten::surface_fitting
