#pragma once

#include "num/patches.hpp"

namespace batten::patches {

/// The polynomials of `shape` with these coefficients, by Horner's rule in v, then in u.
///
/// With fused multiply-adds where the processor has them: the last bits depend on it.
/// Shapes: 12 x 12, 10 x 10 and 8 x 8 of 4 outputs, 10 x 10 of 2, 12 x 1 of 2.
Outputs polynomial(const Shape& shape, const double* coefficients, double u, double v);

}  // namespace batten::patches
