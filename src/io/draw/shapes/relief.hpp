#pragma once

#include "io/draw/shapes/frame.hpp"

namespace batten::drawing {

/// The box of a relief with some air above and below; no side is flat.
Box relief_room(const Box& box);

/// Seen as `space_frame` sees, each axis with its own unit: the floor keeps its proportion between
/// 1:2 and 2:1, heights take 0.62 of its longer side.
Frame relief_frame(const Box& room, Rect area, double padding);

/// Height over width of the picture of a relief.
double relief_aspect(const Box& room);

}  // namespace batten::drawing
