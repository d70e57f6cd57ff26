#pragma once

#include <span>
#include <vector>

#include "make/fit_surface/axis.hpp"
#include "make/fit_surface/nodes.hpp"
#include "num/tensor.hpp"

namespace batten::surface_fitting {

/// The products of a full grid's weighted heights with splines F_i(x), F_j(y), row after row.
///
/// Law:    blocks of any size give the same, to rounding.
/// Memory: the products, and 16 rows of coefficients.
/// Cost:   one pass over a block, another where its rows are fitted so well that sums would cancel.
class HeightProducts {
public:
    /// Borrows all three; the heights come by `add`.
    HeightProducts(const Nodes& nodes, const Axis& x, const Axis& y);
    HeightProducts(const HeightProducts&) = delete;
    HeightProducts& operator=(const HeightProducts&) = delete;

    /// Whole rows, from row `first` on, each once.
    void add(std::size_t first, std::span<const double> z);

    std::vector<double> both;     ///< with F_i and F_j: x functions by y functions
    std::vector<double> x_lines;  ///< with the F_j made orthonormal: y functions by x-lines
    std::vector<double> y_lines;  ///< with the F_i, without the weights of y: x functions by y-lines
    double left_sq = 0;           ///< what the F_j leave of the rows

private:
    void add_few(num::PlaceRange rows, std::span<const double> z);
    double residual_sq(num::PlaceRange rows, std::span<const double> z) const;

    const Nodes& nodes_;
    const Axis &x_, &y_;
    num::TensorSide each_row_;
    num::Tensor tensor_, rows_;
    std::vector<double> part_;  ///< with the F_j: some rows by y functions
};

}  // namespace batten::surface_fitting
