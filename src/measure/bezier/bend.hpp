#pragma once

#include <optional>
#include <vector>

#include "measure/bezier/panel.hpp"

namespace batten::bezier {

/// p x p' of a stretch: the minors p_i p_j' - p_j p_i', i < j, as polynomials in w. With the rest
/// factor s = w^a (1 - w)^b of the stretch
///     dr/dw x d2r/dw2 = s^2 (p x p'),   |curvature| = |p x p'| / (s |p|^3).
struct Bend {
    std::vector<bernstein::Coefficients> minors;
    double noise = 0;  ///< error of the coefficients

    bool is_straight() const;
    /// Sum of the squares of the minors at w.
    double size_sq(double w) const;
};

/// In the plane one minor, positive where the curve turns left; on a line none.
///
/// The noise is that of the rounding of the coefficients and coordinates, and of following.
Bend bend_of(const Pieces& pieces, const Stretch& stretch);

/// p x p' divided by w^at_start (1 - w)^at_end, or nothing if that leaves a pole.
std::optional<Bend> without_zeros(Bend bend, int at_start, int at_end);

}  // namespace batten::bezier
