#pragma once

#include "io/draw/prepare.hpp"
#include "io/draw/scene/scene.hpp"
#include "io/draw/shapes/frame.hpp"

namespace batten::drawing {

/// Draws the shadow of a layer in space on the floor z = `floor`: it makes heights readable.
/// Curves and polylines have one; points stand on stems unless they are many.
void draw_shadow(Scene& scene, const ReadyLayer& layer, const Frame& frame, double floor);

}  // namespace batten::drawing
