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

/// A few rows under a cubic surface: its height in row r is the sum of factors[4 r + i] lines[i].
struct CubicRows {
    const double* z;
    std::size_t stride;  ///< from row to row
    std::array<const double*, 4> lines;
    const double* factors;
    std::array<double, 4> weight;  ///< of each row, times
    const double* weights;         ///< these, unless null
    std::size_t count;             ///< of columns
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
    /// Takes in as many of the rows, 1 to 4.
    void add(const CubicRows& piece, std::size_t rows);
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
    /// Takes in a block of the surface; `x` are its splines.
    void add(const num::Tensor::Block& block, const num::TensorSide& x);
    void finish(Misfit& result) const { totals_.finish(result, nodes_.count); }

private:
    const double* weights(std::size_t from, num::PlaceRange columns);
    double row_weight(std::size_t r) const {
        return nodes_.x_weight[r] * (has_one_weight_ ? nodes_.y_weight[0] : 1);
    }
    void add_cubic(const num::Tensor::Block& block, const num::TensorSide& x);

    const Nodes& nodes_;
    bool has_one_weight_;  ///< in each row
    ResidualTotals totals_;
    std::vector<double> weights_, heights_;
};

}  // namespace batten::surface_fitting
