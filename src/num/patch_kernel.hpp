#pragma once

#include "num/patches.hpp"

namespace batten::patches {

/// The polynomials of `shape` with these coefficients, by Horner's rule in v, then in u.
///
/// Shapes: 12 x 12 and 10 x 10 of 4 outputs.
/// Accuracy: the best the processor offers is chosen at run time (AVX-512, AVX2 with fused
/// multiply-add, plain code); results agree to a few units in the last place of the largest
/// coefficient.
Outputs polynomial(const Shape& shape, const double* coefficients, double u, double v);

/// The sum of c[i] x^i for i < 8: few steps that wait for one another.
inline double polynomial_8(const double* c, double x) {
    const double x2 = x * x;
    return ((c[0] + c[1] * x) + (c[2] + c[3] * x) * x2) +
           ((c[4] + c[5] * x) + (c[6] + c[7] * x) * x2) * (x2 * x2);
}

/// The sum of c[j][i] x^i y^j for i, j < 8, at the best level.
double polynomial_8x8(const double* coefficients, double x, double y);

/// The levels of `polynomial`, for comparisons; `is_offered` says whether this processor has one.
enum class Level { plain, avx2, avx512 };
bool is_offered(Level level);
Outputs polynomial_at(Level level, const Shape& shape, const double* coefficients, double u,
                      double v);

}  // namespace batten::patches
