#pragma once

#include <cstddef>
#include <vector>

#include "batten/shape/basis.hpp"

/// Knot vectors taken apart and put together.
namespace batten::knots {

/// One more than the highest degree a basis may have: room for the coefficients of a piece.
constexpr int most_order = BSplineBasis::most_degree + 1;

/// The list that makes `basis`: what its constructor took, or `BSplineBasis::periodic`.
std::vector<double> list_of(const BSplineBasis& basis);

/// The basis of the same kind over another list.
BSplineBasis basis_over(std::vector<double> list, int degree, bool is_periodic);

/// The longest span of the domain in function j's support, of equals the one nearest to its middle:
/// from the polynomial there the control point is found without cancellation
/// [DeBoor2001, chapter XI: the condition of the B-spline basis].
std::size_t widest_span(const BSplineBasis& basis, std::size_t j);

}  // namespace batten::knots
