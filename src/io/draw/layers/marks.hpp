#pragma once

#include <string_view>

#include "batten/io/draw/layers.hpp"
#include "io/draw/scene/scene.hpp"

/// The strokes and signs that layers and their swatches in the legend share.
namespace batten::drawing {

Paint line_paint(const LineStyle& style, Tone tone);
Paint dot_paint(Marker marker, Tone tone, double radius);
Paint region_paint(Tone tone);
Paint tooth_paint(Tone tone);
Paint envelope_paint(Tone tone);
Paint leg_paint(Tone tone);     ///< of a control polygon
Paint handle_paint(Tone tone);  ///< of its control points
Paint tick_paint(Tone tone);

void add_square(Path& path, Pixel centre, double half);

inline constexpr double handle_half = 2;  ///< half the side of a control point's square

/// Arrows of one tone, collected and then drawn together.
class ArrowMarks {
public:
    /// An arrow from `foot`; `reach` must not be zero.
    void add(Pixel foot, Pixel reach);
    void draw(Scene& scene, Tone tone) const;

private:
    Path shafts_, heads_;
};

}  // namespace batten::drawing
