#pragma once

#include <span>

#include "num/patch_kernel.hpp"

/// Angles of many vectors of the plane, and back, by the best the processor offers. No sum of
/// products is fused: every level gives the same bits.
namespace batten::num {

/// atan2(y, x) in (-pi, pi]: a y of -0 counts as 0.
///
/// Requires: spans of one size, no vector (0, 0) and none beyond 2^1000.
/// Law: -y gives the negative angle, exactly, but where that is -pi.   Accuracy: 3 ulps.
/// Cost: 2 to 5 ns.
void fill_angles(std::span<const double> x, std::span<const double> y, std::span<double> angles);

/// cos and sin of angles in [-4, 4].
///
/// Law: the negative angle gives the same cosine and the negative sine, exactly.
/// Accuracy: 2e-16.   Cost: 2 to 5 ns.
void fill_directions(std::span<const double> angles, std::span<double> cosines,
                     std::span<double> sines);

/// The same bits for one.
double angle_of(double x, double y);
struct Direction {
    double cosine, sine;
};
Direction direction_of(double angle);

/// The same at a level that the processor offers, for comparisons.
void fill_angles_at(patches::Level level, std::span<const double> x, std::span<const double> y,
                    std::span<double> angles);
void fill_directions_at(patches::Level level, std::span<const double> angles,
                        std::span<double> cosines, std::span<double> sines);

}  // namespace batten::num
