#pragma once

#include <vector>

#include "batten/io/draw/surface_layers.hpp"
#include "io/draw/scene/scene.hpp"
#include "io/draw/shapes/frame.hpp"

namespace batten::drawing {

/// A cell of a map: its part of the plane and its number.
struct MapCell {
    Interval x, y;
    double value = 0;
};

/// The cells of a map, rows of constant y one after the other, `most_x` x `most_y` at most.
std::vector<MapCell> cells_of(const MapLayer& map, std::size_t most_x, std::size_t most_y);

/// The part of the plane that a map has no numbers for, in boxes of at most a cell each, of the
/// same division of the plane as `cells_of`.
std::vector<MapCell> gaps_of(const MapLayer& map, std::size_t most_x, std::size_t most_y);

/// Slanted lines over a box, so that lines of neighbouring boxes meet; beneath them a pale ground.
void draw_hatching(Scene& scene, const std::vector<Rect>& boxes);

/// What the colours of a map span.
Interval range_of(const MapLayer& map);

void draw_map(Scene& scene, const MapLayer& map, const Frame& frame);

}  // namespace batten::drawing
