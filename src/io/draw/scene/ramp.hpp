#pragma once

#include <string_view>

#include "batten/io/draw/surface_layers.hpp"

namespace batten::drawing {

inline constexpr int ramp_classes = 17;
inline constexpr int shade_classes = 18;

/// The colour of a class of numbers, 0 the lowest of `ramp_classes`.
std::string_view ramp_color(Ramp ramp, int which);

/// A sheet of this tone where light falls on it, 0 the darkest of `shade_classes`.
std::string_view shade_color(Tone tone, int which);

/// The class of `x` among `classes` of equal width that make up `range`.
int class_of(double x, Interval range, int classes);

}  // namespace batten::drawing
