#pragma once

#include "io/draw/prepare.hpp"
#include "io/draw/scene/scene.hpp"
#include "io/draw/shapes/frame.hpp"

namespace batten::drawing {

/// Draws the layers of a panel; in space also the shadows on the floor of `room`, which is the
/// box around it.
void draw_layers(Scene& scene, const ReadyPanel& panel, const Frame& frame, const Box& room);

}  // namespace batten::drawing
