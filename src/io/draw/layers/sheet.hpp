#pragma once

#include "batten/io/draw/surface_layers.hpp"
#include "io/draw/scene/scene.hpp"
#include "io/draw/shapes/frame.hpp"

namespace batten::drawing {

/// The cells of a sheet from the farthest to the nearest, each followed by what lies upon it.
void draw_sheet(Scene& scene, const SheetLayer& sheet, const Frame& frame);

}  // namespace batten::drawing
