#pragma once

#include <string>

#include "io/draw/scene/scene.hpp"

namespace batten::drawing {

/// The scene as an SVG document, pixels to two decimals. Texts may hold any bytes: what is not
/// UTF-8 or not allowed in XML becomes U+FFFD.
std::string svg(const Scene& scene);

}  // namespace batten::drawing
