#pragma once

#include "batten/make/pseudo_segment.hpp"

namespace batten::pseudo {

/// The angle modulo 2 pi in (-pi, pi]; unchanged if it is there already.
double wrap(double angle);

/// A pair of end angles brought into the quarter 0 <= theta0 <= pi, |theta1| <= theta0 by the
/// mirror (-theta0, -theta1) and the reversal (theta1, theta0), and the way back.
///
/// Angles nearer than 1e-5 to an x node are moved away from it to that distance, since the
/// magnitudes have no limit there.
class Quarter {
public:
    Quarter(double theta0, double theta1);

    double theta0() const { return theta0_; }
    double theta1() const { return theta1_; }
    /// The segment of the quarter domain as one of the angles given.
    PseudoSegment back(const PseudoSegment& segment) const;
    /// A segment of the angles given as one of the quarter domain.
    PseudoSegment into(const PseudoSegment& segment) const;

private:
    double given0_, given1_;
    double theta0_, theta1_;
    bool is_swapped_;
};

}  // namespace batten::pseudo
