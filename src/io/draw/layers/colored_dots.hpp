#pragma once

#include "batten/io/draw/layers.hpp"
#include "io/draw/scene/scene.hpp"
#include "io/draw/shapes/frame.hpp"

namespace batten::drawing {

/// What the colours of the dots span.
Interval range_of(const ColoredPointsLayer& layer);

void draw_colored_dots(Scene& scene, const ColoredPointsLayer& layer, const Frame& frame);

}  // namespace batten::drawing
