#pragma once

#include <array>

namespace batten::fitting {

/// A vector in space; of one in the plane the last coordinate is 0.
using Vector = std::array<double, 3>;

double inner(const Vector& a, const Vector& b);

/// Unit vectors across a tangent of any length, 0 across none. In the plane (dim 2) the first lies
/// to the left and the second is 0.
std::array<Vector, 2> normals_of(const Vector& tangent, int dim);

}  // namespace batten::fitting
