#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// Rows of numbers at the speed of the processor's vectors, summed in a fixed order: the same bits
/// whatever vectors there are.
namespace batten::num {

double dot(std::span<const double> a, std::span<const double> b);
double sum_of_squares(std::span<const double> a);
/// to += factor row.
void add_times(double factor, std::span<const double> row, std::span<double> to);
/// to += sum over i of factors[i] row i; the rows stand one after the other.
void add_combination(std::span<const double> factors, std::span<const double> rows,
                     std::span<double> to);
/// to[i] += dot of row i and `with`.
void add_dots(std::span<const double> rows, std::span<const double> with, std::span<double> to);

/// A matrix of so many rows turned into columns.
std::vector<double> transposed(std::span<const double> matrix, std::size_t rows);

}  // namespace batten::num
