#pragma once

#include "io/draw/layout.hpp"
#include "io/draw/scene/scene.hpp"

namespace batten::drawing {

/// Draws how a layer looks beside its name in the legend.
void draw_swatch(Scene& scene, const LegendPlace& place);

}  // namespace batten::drawing
