#pragma once

#include <array>
#include <complex>

#include "batten/make/pseudo_segment.hpp"

namespace batten::pseudo {

/// The variables of the pseudo-energy, in the order of gradients and Hessians.
enum Variable { ln_r0 = 0, ln_r1 = 1, angle0 = 2, angle1 = 3 };

/// E, L and J = E L^2 of one segment with derivatives of J in the first V variables; J is
/// infinite (and the derivatives are zero) if the segment has a cusp.
template <int V>
struct Expansion {
    double energy = 0;
    double length = 0;
    double value = 0;
    std::array<double, V> gradient{};
    std::array<std::array<double, V>, V> hessian{};
};

/// E, L, J of the segment on the unit chord. Requires r0, r1 > 0.
///
/// Accuracy: a few 1e-16 relative for every segment without a cusp, hairpins included.
/// Cost: 8 to 48 nodes per smooth piece, about 10 ns each.
/// Source: [InoueShibata, eq. 6, 7], with x' y'' - y' x'' as the quadratic that it is.
Expansion<0> expand_value(const PseudoSegment& segment);

/// ... with gradient and Hessian in (ln r0, ln r1).
Expansion<2> expand_magnitudes(const PseudoSegment& segment);

/// ... with gradient and Hessian in (ln r0, ln r1, theta0, theta1). At a minimum over r0, r1 the
/// angle part of the gradient is that of min J (envelope theorem).
Expansion<4> expand_all(const PseudoSegment& segment);

}  // namespace batten::pseudo
