#pragma once

#include <string>

#include "batten/io/draw/drawing.hpp"

namespace batten::drawing {

/// Throws the errors of `svg(const Drawing&)` that can be seen before anything is evaluated.
void require_drawable(const Drawing& drawing);

/// Throws `drawing.dimension` unless `dim` is 2 or 3.
void require_plane_or_space(int dim, const std::string& place);

}  // namespace batten::drawing
