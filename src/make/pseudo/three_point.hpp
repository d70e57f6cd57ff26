#pragma once

#include <optional>

namespace batten::pseudo {

/// Three points seen from the middle one.
struct ThreePoints {
    double turn = 0;  // angle from the first chord to the second
    double length0 = 1;
    double length1 = 1;
};

/// A tangent at the middle point: its angle from the first chord in (-pi, pi], and the energy
/// w = length0^p J(angle) + length1^p J(angle - turn).
struct ThreePointAngle {
    double angle = 0;
    double energy = 0;
    bool is_converged = true;
};

/// ratio^p, kept in [1e-60, 1e60]: beyond, the lighter chord has no say left in double precision.
double relative_weight(double ratio, double weight_exponent);

/// The tangent at the middle of three points that minimises w over the whole circle, with
/// p = `weight_exponent` (the paper: 1).
///
/// Laws:     the mirror image (-turn) and reversal (lengths swapped: turn - angle) hold exactly;
///           lengths times 2^k leave the angle as it is, bit for bit.
///           Equal weights give exactly the bisector: near turn = 102 degrees J(theta) has a
///           concave kink at the bisector, and two tangents 0.6 degrees to its sides are 1e-4 lower
///           in w; they are passed over, so that a circle's points have a circle's tangents.
///           An exact fold-back (turn = pi) has two equal minima; the one on the left is taken.
/// Accuracy: angle to 1e-12, w to 1e-14 relative.
/// Cost:     0.1 ms with equal weights, else about 0.5 ms.
/// Source:   [InoueShibata, eq. 11] with absolute angles and both spans measured alike, which
///           reversal permits. J grows with |theta|, so the least minimum lies between the chords.
ThreePointAngle three_point_angle(const ThreePoints& points, double weight_exponent);

/// The minimum of w on the other side, backwards along the chords, if there is one; its w is never
/// lower. Laws and accuracy as above.
std::optional<ThreePointAngle> three_point_rival(const ThreePoints& points, double weight_exponent);

}  // namespace batten::pseudo
