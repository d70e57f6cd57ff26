#pragma once

#include "batten/io/draw/drawing.hpp"
#include "io/draw/scene/scene.hpp"

namespace batten::drawing {

/// The drawing in pixels, ready for any sink. Throws as `svg(const Drawing&)` says.
Scene scene_of(const Drawing& drawing);

}  // namespace batten::drawing
