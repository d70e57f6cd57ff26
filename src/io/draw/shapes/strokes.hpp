#pragma once

#include <span>
#include <vector>

#include "batten/base/points.hpp"
#include "io/draw/scene/scene.hpp"
#include "io/draw/shapes/frame.hpp"
#include "io/draw/shapes/trace.hpp"

namespace batten::drawing {

/// A trace in pixels. Pieces shorter than a third of a pixel are drawn together as one chord.
Path path_of(const Trace& trace, const Frame& frame);

/// Straight lines through the points; vertices closer than a third of a pixel to the one before
/// are left out, but not the last.
Path path_of(const std::vector<Points>& runs, const Frame& frame);

/// The points in pixels.
std::vector<Pixel> pixels_of(PointsView points, const Frame& frame);

/// A radius that leaves room between neighbours: 3 pixels, less where points lie dense.
double dot_radius(std::span<const Pixel> centres);

/// Indices of the dots that can be seen: the first of each cell of half a radius.
std::vector<std::size_t> visible_dots(std::span<const Pixel> centres, double radius);

}  // namespace batten::drawing
