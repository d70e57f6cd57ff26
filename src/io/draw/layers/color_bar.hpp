#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batten/io/draw/layers.hpp"
#include "io/draw/scene/scene.hpp"

namespace batten::drawing {

/// What the colours of a layer say.
struct ColorBar {
    std::string name;  ///< of what; empty: no bar is drawn
    Ramp ramp = Ramp::rising;
    Interval range;
    std::vector<BarMark> marks;
};

/// Nothing for layers whose colours are no numbers.
std::optional<ColorBar> bar_of(const Layer& layer);

/// Of numbers in the range found, or symmetric about 0 on a diverging ramp.
Interval color_range(Interval found, Ramp ramp);

/// The bar, its upper left corner at `corner`, with its numbers below; `width` is the panel's.
void draw_bar(Scene& scene, const ColorBar& bar, Pixel corner, double width);
inline constexpr double bar_room = 44;  ///< what it needs below a panel

}  // namespace batten::drawing
