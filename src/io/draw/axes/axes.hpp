#pragma once

#include <string>

#include "io/draw/axes/ticks.hpp"
#include "io/draw/prepare.hpp"
#include "io/draw/scene/scene.hpp"
#include "io/draw/shapes/frame.hpp"

namespace batten::drawing {

/// What stands along the two axes of a panel in the plane.
struct PlaneAxes {
    AxisTicks x, y;
    bool marks_zero = false;  ///< whether the line y = 0 stands out, as in a chart
    std::string x_name, y_name;  ///< with the notes of the ticks
    bool has_x_numbers = true;
    bool has_y_numbers = true;

    bool has_x_name() const { return has_x_numbers && !x_name.empty(); }
    bool has_y_name() const { return has_y_numbers && !y_name.empty(); }
};

/// Ticks and names for a panel seen through `frame`.
PlaneAxes plane_axes(const ReadyPanel& panel, const Frame& frame);

/// Grid lines, numbers and names of a panel in the plane.
void draw_plane_axes(Scene& scene, const PlaneAxes& axes, const Frame& frame);

/// The three back walls of `room` with their grid, numbers along the outer edges, and the names of
/// the axes.
void draw_space_axes(Scene& scene, const Panel& panel, const Frame& frame, const Box& room);

}  // namespace batten::drawing
