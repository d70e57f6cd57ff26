#pragma once

#include <optional>

#include "batten/shape/curve.hpp"
#include "batten/shape/spline_function.hpp"

namespace batten {

/// The spline S whose graph `curve` is: a B-spline of the plane whose first coordinate is its
/// parameter, to rounding. Nothing where it is none.
///
/// Law: spline_of_graph(graph(s)) is s, its ends clamped, bit for bit.
std::optional<SplineFunction> spline_of_graph(const Curve& curve);

}  // namespace batten
