#pragma once

#include <cstddef>

#include "batten/shape/curve.hpp"
#include "io/draw/shapes/trace.hpp"

namespace batten::drawing {

/// How a curve bends at one place, curvature in units of 1 / size.
struct Bend {
    Spot at{};
    Spot tangent{};  ///< of length 1
    Spot outward{};  ///< of length 1, away from the centre of curvature; zero where it is straight
    double curvature = 0;  ///< signed in the plane (left turns positive), magnitude in space
    bool exists = false;  ///< false at a cusp and where the radius is below 1e-4 of size
};

/// The one-sided limit of piece `piece` at `t`, where `size` is the extent of the picture.
Bend bend_of(const Curve& curve, std::size_t piece, double t, double size);

/// The largest |curvature| of a curve, in units of 1 / size, to about 1e-3; 0 for a straight line.
double peak_curvature(const Curve& curve, double size);

}  // namespace batten::drawing
