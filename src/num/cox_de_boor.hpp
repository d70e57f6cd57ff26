#pragma once

#include <cstddef>
#include <span>

/// The B-splines that are not zero on one span, for hot loops: no checks, no allocation.
namespace batten::num {

/// The largest order (degree + 1) the kernels of this file hold on the stack.
constexpr int most_order = 32;

/// Values at `x` of the `order` B-splines that are not zero on [knots[span], knots[span + 1]], into
/// `out[0 ... order - 1]`; the first is function span - order + 1.
///
/// Outside the span the polynomials are continued. The span must have positive length.
/// Accuracy: a few ulps inside the span: every term is positive there.
/// Source: [deBoor2001, X(9)].
void basis_values(std::span<const double> knots, std::size_t span, int order, double x,
                  double* out);

/// The same for `count` abscissae at once: `out[j * count + i]` is function j at x[i].
void basis_values_at(std::span<const double> knots, std::size_t span, int order, const double* x,
                     int count, double* out);

/// Derivatives of order `derivative` at `x` of the same functions, one-sided where x is an end of the
/// span. Source: differences of values of lower order [deBoor2001, X(15)].
void basis_derivatives(std::span<const double> knots, std::size_t span, int order, double x,
                       int derivative, double* out);

}  // namespace batten::num
