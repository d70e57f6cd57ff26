#pragma once

#include <array>

#include "num/clones.hpp"
#include "shape/knots.hpp"

namespace batten::knots {

/// One piece of a spline in power form: c[0] + c[1] u + ..., u from the piece's start.
using PowerForm = std::array<double, most_order>;

/// At one u, or at several at once; the same bits either way.
template <int Degree, class Number>
BATTEN_INLINE void horner_at(const PowerForm& c, const Number& u, Number& out) {
    out = Number{} + c[Degree];
    for (std::size_t j = Degree; j-- > 0;) out = out * u + c[j];
}

}  // namespace batten::knots
