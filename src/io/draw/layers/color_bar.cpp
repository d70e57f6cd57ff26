#include "io/draw/layers/color_bar.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "io/draw/axes/ticks.hpp"
#include "io/draw/layers/colored_dots.hpp"
#include "io/draw/layers/map.hpp"
#include "io/draw/scene/ramp.hpp"
#include "io/draw/scene/text_layout.hpp"
#include "io/draw/scene/theme.hpp"

namespace batten::drawing {
namespace {

constexpr double bar_height = 8;
constexpr double bar_share = 0.62;  ///< of the panel's width; the rest is for its name

Path outline(Pixel a, Pixel b) {
    Path path;
    path.move_to(a);
    path.line_to({b.x, a.y});
    path.line_to(b);
    path.line_to({a.x, b.y});
    path.close();
    return path;
}

/// Marks whose texts have room between one another and both ends.
bool have_room(const ColorBar& bar, double wide, const std::function<double(double)>& place) {
    constexpr double air = 8;
    double taken = text_width(short_number(bar.range.lo), label_size);
    for (const BarMark& mark : bar.marks) {
        const double half = 0.5 * text_width(mark.text, label_size), x = place(mark.at);
        if (x - half < taken + air) return false;
        taken = x + half;
    }
    return taken + air + text_width(short_number(bar.range.hi), label_size) < wide;
}

}  // namespace

std::optional<ColorBar> bar_of(const Layer& layer) {
    if (const auto* map = std::get_if<MapLayer>(&layer)) {
        return ColorBar{map->bar, map->ramp, range_of(*map), map->marks};
    }
    if (const auto* dots = std::get_if<ColoredPointsLayer>(&layer)) {
        return ColorBar{dots->bar, dots->ramp, range_of(*dots), dots->marks};
    }
    return std::nullopt;
}

Interval color_range(Interval found, Ramp ramp) {
    if (ramp == Ramp::rising) return found;
    const double most = std::max(std::fabs(found.lo), std::fabs(found.hi));
    return {-most, most};
}

void draw_bar(Scene& scene, const ColorBar& bar, Pixel corner, double width) {
    const Interval range = bar.range;
    const double wide = bar_share * width, step = wide / ramp_classes;
    for (int k = 0; k < ramp_classes; ++k) {
        scene.add(PathShape{outline(corner + Pixel{k * step, 0}, corner + Pixel{(k + 1) * step, bar_height}),
                            {{}, 1, ramp_color(bar.ramp, k)}});
    }
    scene.add(PathShape{outline(corner, corner + Pixel{wide, bar_height}), {axis_color, 0.8}});
    const auto write = [&](double x, const std::string& text, Anchor anchor) {
        scene.add(TextShape{corner + Pixel{x, bar_height + 13}, text, label_size, anchor,
                            text_color});
    };
    write(0, short_number(range.lo), Anchor::start);
    write(wide, short_number(range.hi), Anchor::end);
    Path ticks;
    const double length = 0.5 * range.hi - 0.5 * range.lo;
    const auto place = [&](double at) { return wide * ((0.5 * at - 0.5 * range.lo) / length); };
    const bool has_marks = length > 0 && have_room(bar, wide, place);
    for (const BarMark& mark : bar.marks) {
        if (!has_marks || !range.contains(mark.at)) continue;
        const double x = place(mark.at);
        ticks.move_to(corner + Pixel{x, -2});
        ticks.line_to(corner + Pixel{x, bar_height + 2});
        write(x, mark.text, Anchor::middle);
    }
    scene.add(PathShape{ticks, {ink_color, 1}});
    scene.add(TextShape{corner + Pixel{wide + 10, bar_height},
                        shortened(bar.name, label_size, width - wide - 10), label_size,
                        Anchor::start, text_color});
}

}  // namespace batten::drawing
