#pragma once

#include <array>
#include <span>
#include <vector>

#include "make/fit_surface/solve.hpp"
#include "num/lanes.hpp"
#include "num/tensor.hpp"

namespace batten::surface_fitting {

/// A piece of one row: heights, the surface there, and weights.
struct Piece {
    const double* z;
    const double* heights;  ///< null: 0
    double weight;          ///< of the whole row
    const double* weights;  ///< times these, unless null
    std::size_t count;
};

/// What the residuals of pieces come to. Lane by lane: all widths of vectors give the same bits.
class ResidualTotals {
public:
    struct Sums {
        std::array<double, num::lanes> delta2{};
        std::array<double, num::lanes> highest{}, lowest{};  ///< data units, where weight is
        /// Beyond one, two, three standard deviations.
        std::array<std::array<double, num::lanes>, 3> beyond{};
    };

    /// Takes in a piece; e, which may be where its heights or z are, becomes its weighted residuals.
    void add(const Piece& piece, double* e);
    /// Takes in weighted residuals.
    void add(std::vector<double>& e) { add({e.data(), nullptr, 1, nullptr, e.size()}, e.data()); }
    /// delta2, psi and the largest residual in data units, of `count` nodes.
    void finish(Misfit& result, std::size_t count) const;

private:
    Sums sums_;
    std::array<double, psi_count> beyond_{};  ///< four standard deviations and more
};

/// The same for the nodes of a grid.
class NodeTotals {
public:
    explicit NodeTotals(const Nodes& nodes);

    /// Takes in a piece of row r from the surface's heights there, which e may replace.
    void add(std::size_t r, num::PlaceRange columns, const double* heights, double* e);
    void finish(Misfit& result) const { totals_.finish(result, nodes_.count); }

private:
    const double* weights(std::size_t from, num::PlaceRange columns);

    const Nodes& nodes_;
    bool has_one_weight_;  ///< in each row
    ResidualTotals totals_;
    std::vector<double> weights_;
};

}  // namespace batten::surface_fitting
