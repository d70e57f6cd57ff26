#pragma once

#include <vector>

namespace batten {

/// The cubic from (0, 0) to (1, 0) that leaves with the tangent vector r0 (cos theta0, sin theta0)
/// and arrives with r1 (cos theta1, sin theta1); both point in the direction of travel, angles are
/// in radians from the chord, positive to the left [InoueShibata, eq. 1-5].
struct PseudoSegment {
    double theta0 = 0;
    double theta1 = 0;
    double r0 = 1;
    double r1 = 1;
};

/// The paper's shape of a segment [InoueShibata, eq. 13]. Its type x, both end tangents along the
/// chord and one of them backwards, has a cusp: it cannot be measured.
enum class PseudoType {
    c,  ///< the end curvatures do not differ in sign
    s   ///< they do: an inflection
};

/// What a segment on the unit chord measures. On a chord of length l: length l L, area l^2 S,
/// energy E / l, pseudo-energy l J, curvatures k / l.
struct PseudoMeasures {
    double energy = 0;           ///< E, the integral of curvature^2 over arc length
    double length = 0;           ///< L
    double pseudo_energy = 0;    ///< J = E L^2
    double area = 0;             ///< S between curve and chord, positive to the left of the chord
    double start_curvature = 0;  ///< positive where the curve turns left
    double end_curvature = 0;
    PseudoType type = PseudoType::c;
};

/// The measures of any segment.
///
/// Accuracy: a few 1e-15 relative in E, L, J, also at hairpins; S and the curvatures are closed
/// forms.
/// Cost: 0.3 to 2 microseconds.
/// Throws: `pseudo.angle` unless both angles are finite; `pseudo.magnitude` unless both magnitudes
/// lie in [1e-9, 1e9]; `pseudo.cusp` if the curve stops on its way, where E is infinite.
/// Source: [InoueShibata, eq. 6, 7, 14]; S = (r0 sin theta0 - r1 sin theta1) / 10
///         - r0 r1 sin(theta0 - theta1) / 60.
PseudoMeasures measure(const PseudoSegment& segment);

/// The segment of least J over r0, r1 for given end angles, which are taken modulo 2 pi.
///
/// Laws:     mirror image (-theta0, -theta1) has the same r0, r1, and reversal (theta1, theta0) has
///           them swapped, exactly; an arc (theta, -theta) has r0 == r1.
/// Accuracy: J to 1e-14 relative; r to 1e-12, but only to the square root of J's flatness where
///           |theta0 + theta1| is small against 1: r is not a smooth function of the angles there.
///           Closer than 1e-5 to an x node (pi, 0), (0, pi), (pi, pi), where J is unbounded, the
///           magnitudes are those at that distance.
/// Cost:     about 60 evaluations of J with its Hessian, 0.1 ms.
/// Throws:   `pseudo.angle` unless both angles are finite.
PseudoSegment least_pseudo_segment(double theta0, double theta1);

/// All local minima of J over r0, r1 that a scan of starts over 0.005 <= r0, r1 <= 60 finds, the
/// lowest first; the first is `least_pseudo_segment`. Laws and errors as above; 3 to 10 ms.
std::vector<PseudoSegment> pseudo_minima(double theta0, double theta1);

}  // namespace batten
