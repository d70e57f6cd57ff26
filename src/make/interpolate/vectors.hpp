#pragma once

#include <span>
#include <vector>

/// Directions in space of any dimension.
namespace batten::interpolation {

using Vector = std::vector<double>;

double dot(std::span<const double> a, std::span<const double> b);

/// From `a` to `b`, of length 1; zeros where they are the same.
Vector direction(std::span<const double> a, std::span<const double> b);

/// `vector` mirrored at the line along the unit vector `axis`.
Vector mirrored(std::span<const double> vector, std::span<const double> axis);

/// A unit vector across `direction`: in the plane to the left, in space across the coordinate axis
/// that `direction` follows least.
Vector across(std::span<const double> direction);

bool is_zero(std::span<const double> vector);

}  // namespace batten::interpolation
