#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace batten::num {

/// A dense matrix, row after row.
struct DenseMatrix {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<double> entries;

    DenseMatrix(std::size_t r, std::size_t c) : rows(r), columns(c), entries(r * c, 0.0) {}
    double& operator()(std::size_t i, std::size_t j) { return entries[i * columns + j]; }
    double operator()(std::size_t i, std::size_t j) const { return entries[i * columns + j]; }
};

/// The x >= 0 that makes |matrix x - right| least.
///
/// Accuracy: that of Householder QR on the columns with x > 0. Cost: as many least-squares
/// problems as columns enter, usually fewer than 2 x columns.
/// Source: [LawsonHanson1974, algorithm NNLS 23.10].
std::vector<double> nonnegative_least_squares(const DenseMatrix& matrix,
                                              std::span<const double> right);

/// The shortest u with matrix u >= right.
struct LeastDistance {
    std::vector<double> point;
    std::vector<std::size_t> active;  ///< rows that hold with equality and push, rising
};

/// Nothing where no u fulfils all rows. Rows may have any length; each is scaled to 1.
///
/// Source: [LawsonHanson1974, algorithm LDP 23.27].
std::optional<LeastDistance> least_distance(const DenseMatrix& matrix,
                                            std::span<const double> right);

}  // namespace batten::num
