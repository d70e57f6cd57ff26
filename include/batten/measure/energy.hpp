#pragma once

#include <optional>

#include "batten/measure/measured.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// int kappa^2 ds over all pieces; corners at the breaks are not counted. In 1 / data units.
///
/// Nothing where the integral diverges or the curve has a cusp: where it stops inside a piece and
/// turns back, or where it stops at the end of a piece with infinite curvature. (At an end passed
/// with zero speed the integral exists if, for example, the piece is straight there.)
///
/// Aim:    |value - energy| <= error, about 1e-14 of it; more towards a cusp, where the curvature
///         itself is known less well.
/// Laws:   points times 2^k give exactly 2^-k times the energy.
/// Cost:   about 4 us a gentle cubic.
/// Throws: `curve.not-finite`; `number.overflow`.
/// Source: as `length`, with the curvature bounded likewise.
std::optional<Measured> bending_energy(const Curve& curve);

/// (int kappa^2 ds) x length: free of scale. Nothing where the bending energy does not exist.
std::optional<Measured> energy_length(const Curve& curve);

/// Sum over the pieces of E_i L_i^2, with E_i = int kappa^2 ds and L_i the length of piece i: what
/// the pseudo-spline keeps small [InoueShibata, eq. 7]. In data units. Nothing where the bending
/// energy does not exist.
std::optional<Measured> pseudo_energy(const Curve& curve);

}  // namespace batten
