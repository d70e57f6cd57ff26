#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace batten::num {

/// A small symmetric matrix, all of it stored.
struct SymmetricMatrix {
    std::size_t size = 0;
    std::vector<double> entries;  ///< size x size

    explicit SymmetricMatrix(std::size_t n) : size(n), entries(n * n, 0.0) {}
    double& operator()(std::size_t i, std::size_t j) { return entries[i * size + j]; }
    double operator()(std::size_t i, std::size_t j) const { return entries[i * size + j]; }
};

/// matrix x vector.
std::vector<double> product(const SymmetricMatrix& matrix, std::span<const double> vector);

/// The x with matrix x = right, or nothing where the matrix is not positive definite to rounding.
///
/// Accuracy: backward stable. Cost: n^3 / 6 multiplications. Source: Cholesky
/// [GolubVanLoan2013, algorithm 4.2.1].
std::optional<std::vector<double>> solve_positive(const SymmetricMatrix& matrix,
                                                  std::span<const double> right);

/// The least eigenvalue, to about n ulps of the largest.
///
/// Cost: some 30 n^3 multiplications. Source: cyclic Jacobi rotations
/// [GolubVanLoan2013, algorithm 8.5.3].
double least_eigenvalue(SymmetricMatrix matrix);

}  // namespace batten::num
