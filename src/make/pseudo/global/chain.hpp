#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace batten::pseudo {

/// A symmetric matrix with a diagonal, entries `beside[i]` between i and i + 1, and `beside.back()`
/// between the last and the first unknown: what unknowns along a curve, open (then 0) or closed,
/// have. Both have the same size.
struct ChainMatrix {
    std::vector<double> diagonal, beside;
};

/// Solves (matrix + shift D) x = right side, where D holds the sums of the absolute entries of the
/// rows; nothing if the matrix on the left is not positive definite, which it is for shift > 1.
///
/// Accuracy: backward stable (Cholesky).   Cost: linear in the number of unknowns.
std::optional<std::vector<double>> solve_shifted(const ChainMatrix& matrix, double shift,
                                                 const std::vector<double>& right_side);

}  // namespace batten::pseudo
