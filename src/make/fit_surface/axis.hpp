#pragma once

#include <optional>
#include <span>
#include <vector>

#include "batten/shape/basis.hpp"
#include "num/banded_qr.hpp"
#include "num/tensor.hpp"

namespace batten::surface_fitting {

/// One direction of a surface fit: the splines at the grid's lines, and the triangle R of their
/// weighted matrix A = Q R.
class Axis {
public:
    /// `used`: the lines that hold any node, for telling which splines the data determine.
    Axis(BSplineBasis basis, std::span<const double> lines, std::span<const double> weights,
         std::span<const double> used);

    const BSplineBasis& basis() const { return basis_; }
    std::size_t functions() const { return basis_.size(); }
    /// The splines as they are, times the weight, times its square.
    const num::TensorSide& plain() const { return plain_; }
    const num::TensorSide& weighted() const { return weighted_ ? *weighted_ : plain_; }
    const num::TensorSide& normal() const { return normal_ ? *normal_ : plain_; }
    /// Splines without a line of their own, or as good as without, rising; the triangle is then made regular by faint
    /// differences, which continue the surface smoothly.
    const std::vector<int>& open() const { return open_; }

    /// The largest diagonal of the triangle over the smallest.
    double spread() const;
    /// Whether normal equations, corrected or not, lose too much.
    bool is_delicate() const;
    /// The least-squares coefficients of functions whose values at the lines, without weights, are
    /// the columns of a lines x width matrix: functions() x width of them. By orthogonal reduction.
    std::vector<double> fitted(std::span<const double> values, std::size_t width) const;
    /// (A^T A)^-1 on the first index of a functions() x width matrix.
    void invert_rows(std::span<double> matrix, std::size_t width) const;
    /// The same on the second index of a matrix with functions() columns.
    void invert_columns(std::span<double> matrix) const;
    /// R c and R^-1 c.
    std::vector<double> times_triangle(std::span<const double> c) const;
    std::vector<double> solved(std::span<const double> c) const;
    /// The faint differences alone on the first index of a functions() x width matrix: R^T R - A^T A.
    std::vector<double> faint_part(const std::vector<double>& matrix, std::size_t width) const;
    bool is_regular() const { return is_regular_; }
    /// The mean of the columns' square sums.
    double mean_sq() const;
    /// R^-T on the first index: half of it; and on the second.
    void forward_rows(std::span<double> matrix, std::size_t width) const;
    void forward_columns(std::span<double> matrix) const;

private:
    void take_unseen_for_open();
    template <class Rows>
    void by_columns(std::span<double> matrix, Rows work) const;

    BSplineBasis basis_;
    num::TensorSide plain_;
    std::optional<num::TensorSide> weighted_, normal_;  ///< unless all weights are 1
    std::vector<double> weights_;
    num::BandedQr triangle_;
    std::vector<int> open_;
    bool is_regular_ = true;
};

/// The B-splines over breaks, each inner one a simple knot.
BSplineBasis basis_over(std::span<const double> breaks, int degree);

/// The strip between two breaks in which t lies.
std::size_t strip_of(const BSplineBasis& basis, double t);

/// Whether the used lines determine all splines over these knots.
bool is_determined(const BSplineBasis& basis, std::span<const double> used);

}  // namespace batten::surface_fitting
