#include "make/pseudo/segment/angles.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace batten::pseudo {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double least_distance = 1e-5;

/// Moves (a, b) away from the node (u, v) along the line from it, towards smaller angles if it
/// sits on the node.
void leave_node(double& a, double& b, double u, double v) {
    const double da = a - u;
    const double db = b - v;
    const double distance = std::sqrt(da * da + db * db);
    if (distance >= least_distance) return;
    const double scale = distance > 0 ? least_distance / distance : 0;
    a = u + (distance > 0 ? da * scale : -0.8 * least_distance);
    b = v + (distance > 0 ? db * scale : -0.6 * least_distance);
}

}  // namespace

double wrap(double angle) {
    const double wrapped = std::remainder(angle, 2 * pi);
    return wrapped <= -pi ? pi : wrapped;
}

Quarter::Quarter(double theta0, double theta1)
    : given0_(wrap(theta0)),
      given1_(wrap(theta1)),
      theta0_(given0_),
      theta1_(given1_),
      is_swapped_(std::fabs(theta1_) > std::fabs(theta0_)) {
    if (is_swapped_) std::swap(theta0_, theta1_);
    // At theta0 = pi = -pi the mirror leaves theta0 as it is, so the sign of theta1 is free.
    const bool is_mirrored = theta0_ < 0 || (theta0_ == pi && theta1_ < 0);
    if (is_mirrored) {
        theta0_ = std::fabs(theta0_);
        theta1_ = -theta1_;
    }
    leave_node(theta0_, theta1_, pi, 0);
    leave_node(theta0_, theta1_, pi, pi);
    leave_node(theta0_, theta1_, pi, -pi);
    theta0_ = std::fmin(theta0_, pi);
}

PseudoSegment Quarter::back(const PseudoSegment& segment) const {
    PseudoSegment s{given0_, given1_, segment.r0, segment.r1};
    if (is_swapped_) std::swap(s.r0, s.r1);
    return s;
}

PseudoSegment Quarter::into(const PseudoSegment& segment) const {
    PseudoSegment s{theta0_, theta1_, segment.r0, segment.r1};
    if (is_swapped_) std::swap(s.r0, s.r1);
    return s;
}

}  // namespace batten::pseudo
