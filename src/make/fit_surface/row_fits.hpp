#pragma once

#include <span>
#include <vector>

#include "make/fit_surface/axis.hpp"

namespace batten::surface_fitting {

/// A side with a function at every place and nowhere else.
num::TensorSide separate_rows(std::size_t count);

/// Rows of a grid, each fitted in y by itself.
class RowFits {
public:
    RowFits(BSplineBasis basis, std::span<const double> places, std::span<const double> weights);
    RowFits(const RowFits&) = delete;
    RowFits& operator=(const RowFits&) = delete;

    const Axis& axis() const { return axis_; }

    /// The most rows that `fit` takes at a time.
    static constexpr std::size_t most_rows = 16;

    struct Fitted {
        std::vector<double> coefficients;  ///< a row of them for every row of heights
        std::vector<double> left_sq;       ///< the weighted square sum of what each leaves
    };
    /// Accuracy: seminormal equations, corrected once where weights or knots are uneven.
    Fitted fit(std::span<const double> z) const;

    /// The weighted square sum, over the places, of a spline with these coefficients.
    double norm_sq(const double* coefficients) const;

private:
    void solve(std::span<const double> z, std::size_t rows, std::vector<double>& c) const;

    std::vector<double> weights_;
    Axis axis_;
    std::vector<double> gram_;  ///< functions x order: the upper band of B^T B
    bool is_harmless_;
    num::TensorSide each_row_;
    num::Tensor plain_, normal_;
};

}  // namespace batten::surface_fitting
