#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "make/fit_surface/axis.hpp"
#include "make/fit_surface/nodes.hpp"
#include "make/fit_surface/solve.hpp"

namespace batten::surface_fitting {

/// What one row says of splines in y: with w the weights of the columns and f the factors,
/// products[j] = sum of w^2 f z N_j and gram[b * functions + j] = sum of w^2 f N_j N_(j + b).
class MaskedRow {
public:
    explicit MaskedRow(const Axis& y);
    void take(std::span<const double> z, std::span<const double> factor_sq);

    std::vector<double> products, gram;

private:
    /// Places with the same splines.
    struct Run {
        std::size_t first, last;
        std::vector<double> values;  ///< w^2 N_j, a row for each j
        std::vector<double> pairs;   ///< w^2 N_j N_(j + b), a row for each b and j
        std::vector<double> whole;   ///< their sums, none missing
    };
    Run run_from(std::size_t first) const;

    const Axis& y_;
    std::vector<Run> runs_;
    std::vector<double> heights_, sums_;
};

/// to += the symmetric band matrix, laid out as a row's gram, times c.
void add_band_product(const double* gram, std::size_t order, std::span<const double> c,
                      std::span<double> to);

/// The normal equations A^T W A c = A^T W z of such a grid: the matrix by its bands in both
/// directions, so that steps of conjugate gradients need not see the nodes.
///
/// Memory: functions in x times functions in y times order^2.
/// Cost:   of nodes that are there order^2 / 2 operations in strips where some are missing, else
///         order; a product with the matrix (2 order)^2 a coefficient.
class MaskedNormals {
public:
    /// Borrows both.
    MaskedNormals(const Axis& x, const Axis& y);

    using Visit = std::function<void(std::size_t r, const MaskedRow& row)>;
    /// Takes in rows, each once; `visit` sees what every row says.
    void add(const MaskedRows& rows, const Visit& visit = {});

    /// A^T W z.
    const std::vector<double>& products() const { return products_; }
    /// A^T W A c.
    std::vector<double> times(std::span<const double> c) const;
    /// By conjugate gradients; `steps` at most (0: as many as it takes).
    Solution solution(int steps = 0) const;
    /// The square sums of the columns of A.
    std::vector<double> diagonal() const;

private:
    const Axis &x_, &y_;
    std::size_t order_;
    MaskedRow row_;
    std::vector<double> products_;
    std::vector<double> matrix_;  ///< for spline i of x and i + a a band matrix in y
};

}  // namespace batten::surface_fitting
