#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/draw/axes/axes.hpp"
#include "io/draw/layers/color_bar.hpp"
#include "io/draw/prepare.hpp"

namespace batten::drawing {

/// Where one panel goes.
struct Place {
    Frame frame;  ///< its area is that of the data, without what stands around it
    PlaneAxes axes;
    std::vector<std::string> caption;
    double caption_y = 0;  ///< the base line of its first line
    double bar_top = 0;    ///< where the colour bar begins, if there is one
    double bar_width = 0;  ///< with its name
};

/// A swatch and its text in the legend; `at` is the left end of the text's base line.
struct LegendPlace {
    Pixel at;
    std::string text;
    const ReadyLayer* layer = nullptr;
};

/// A picture's plan, from the top: title, subtitle, legend, rows of panels.
struct Layout {
    double width = 0;
    double height = 0;
    std::vector<std::string> title;
    std::vector<std::string> subtitle;
    std::vector<LegendPlace> legend;
    std::vector<Place> places;  ///< one a panel
};

inline constexpr double title_leading = 22;
inline constexpr double subtitle_leading = 17;
inline constexpr double caption_leading = 18;
inline constexpr double swatch_width = 22;

/// The first named colour bar of a panel's layers.
std::optional<ColorBar> bar_of(const ReadyPanel& panel);

/// The box of a panel as it is drawn: in space with air around.
Box room_of(const ReadyPanel& panel);

/// How `panel` is seen when its area is `area`.
Frame frame_of(const ReadyPanel& panel, Rect area);

Layout layout_of(const Drawing& drawing, const std::vector<ReadyPanel>& panels);

}  // namespace batten::drawing
