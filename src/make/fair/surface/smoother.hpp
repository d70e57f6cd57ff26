#pragma once

#include <optional>
#include <vector>

#include "make/fair/surface/planes.hpp"

namespace batten::fairing {

/// One direction of a grid: what fourth differences along its lines cost, in their own modes.
///
/// On the free nodes x of a line |D4 x|^2 = x' A x + 2 x' B h + ..., h being its held ends;
/// A = modes stiffness modes'. Differences are divided ones in units of the mean spacing, so on even
/// lines they are 1 -4 6 -4 1 and a wave of w radians a node has stiffness w^8.
struct GridAxis {
    Eigen::Index held = 1;      ///< nodes at each end that stay
    Eigen::Index free = 0;
    double spacing = 1;         ///< mean distance of lines
    Plane modes;                ///< free x free, one a column, the smoothest first
    Eigen::VectorXd stiffness;  ///< rising
    Plane pull;                 ///< B: free x 2 held, those at the start first
};

GridAxis axis_of(const std::vector<double>& knots, std::size_t held);

/// A grid smoothed by fourth differences.
struct Smoothed {
    Planes planes;
    double mu = 0;        ///< weight of the squared fourth differences
    double sigma_sq = 0;  ///< the noise of a coordinate, as given or as left over
};

/// min |X - D|^2 + mu (|D4u X|^2 + |D4v X|^2) over the free nodes, mu of least error to be expected:
/// by Mallows' criterion where sigma is given [Mallows1973], else by generalised cross-validation
/// [CravenWahba1979]. Four trials a decade; waves of 150 nodes are the longest taken out.
Smoothed smoothed(const Planes& data, const GridAxis& u, const GridAxis& v,
                  std::optional<double> sigma);

}  // namespace batten::fairing
