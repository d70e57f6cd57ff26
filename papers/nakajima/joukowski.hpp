#pragma once

#include <array>
#include <span>

#include "batten/batten.hpp"

/// An aerofoil with a cusped tail and the flow round it: the circle round -0.1 + 0.08 i through 1
/// under z = w + 1 / w, in a stream of speed 1 that rises by 5 degrees, with the circulation that
/// lets it leave at the tail. The paper's own data of Figure 6 are lost; these stand in for them.
namespace nakajima {

/// The point of the aerofoil at this angle of the circle, from the tail over the upper side.
std::array<double, 2> aerofoil_point(double angle);

/// How far a point is from the aerofoil between these two angles.
double aerofoil_distance(std::span<const double> point, batten::Interval angles);

/// Length from tail to nose along x.
double chord();

/// The two sides; each takes half a turn of the circle.
enum class Side { upper, lower };
double start_angle(Side side);

/// n + 1 points at equal steps of the circle's angle.
batten::Points aerofoil_points(Side side, int n);

/// y where the stream function is that of the aerofoil plus `psi`, at this x.
double stream_height(double x, double psi);

/// The eight points of a streamline: x = -4 ... 4, denser where it bends.
batten::Points stream_points(double psi);

}  // namespace nakajima
