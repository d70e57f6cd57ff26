#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "batten/base/grid.hpp"
#include "shape/space.hpp"

namespace batten::fairing {

using Plane = Eigen::MatrixXd;

/// A grid of points in space, one matrix (nu x nv) a coordinate.
struct Planes {
    std::array<Plane, 3> at;

    std::size_t nu() const { return static_cast<std::size_t>(at[0].rows()); }
    std::size_t nv() const { return static_cast<std::size_t>(at[0].cols()); }
    space::Vector operator()(std::size_t i, std::size_t j) const {
        const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
        return {at[0](row, column), at[1](row, column), at[2](row, column)};
    }
    void set(std::size_t i, std::size_t j, const space::Vector& p) {
        const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
        for (std::size_t k = 0; k < 3; ++k) at[k](row, column) = p[k];
    }
};

/// The grid's nodes from the first one on, divided by `unit`.
Planes planes_of(const GridView& grid, double unit);

/// Where the lines of a grid lie: the first at 0, then by the mean distance of their nodes.
struct Knots {
    std::vector<double> u, v;
};
Knots knots_of(const Planes& planes);

/// Three-point differences at inner knot i: weights of the knots before, at and after it.
struct Differences {
    std::array<double, 3> first, second;
};
/// `before` and `after` are the distances to its neighbours.
Differences differences(double before, double after);
/// For all inner knots; the first and the last entry are not used.
std::vector<Differences> differences_of(const std::vector<double>& knots);

}  // namespace batten::fairing
