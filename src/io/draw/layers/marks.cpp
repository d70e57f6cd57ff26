#include "io/draw/layers/marks.hpp"

#include <algorithm>

#include "io/draw/scene/theme.hpp"

namespace batten::drawing {
namespace {

constexpr double head_length = 8;
constexpr double head_half = 2.7;
constexpr double smallest_ring = 1.6;  ///< radius: the hole of a smaller one cannot be seen

}  // namespace

Paint line_paint(const LineStyle& style, Tone tone) {
    Paint paint{color_of(tone), style.width};
    if (style.dash == Dash::dashed) paint.dashes = "6 4";
    if (style.dash == Dash::dotted) paint.dashes = "1.5 3.5";
    return paint;
}

Paint dot_paint(Marker marker, Tone tone, double radius) {
    if (marker == Marker::closed) return {paper_color, 0.35 * radius, color_of(tone)};
    if (radius < smallest_ring) return {{}, 1, color_of(tone)};
    return {color_of(tone), std::min(1.3, 0.45 * radius), paper_color};
}

Paint region_paint(Tone tone) { return {{}, 1, color_of(tone), {}, 0.2}; }
Paint tooth_paint(Tone tone) { return {color_of(tone), 0.7, {}, {}, 0.5}; }
Paint envelope_paint(Tone tone) { return {color_of(tone), 1.1}; }
Paint leg_paint(Tone tone) { return {color_of(tone), 0.8}; }
Paint handle_paint(Tone tone) { return {color_of(tone), 0.9, paper_color}; }
Paint tick_paint(Tone tone) { return {color_of(tone), 1.2}; }

void add_square(Path& path, Pixel centre, double half) {
    path.move_to(centre + Pixel{-half, -half});
    path.line_to(centre + Pixel{half, -half});
    path.line_to(centre + Pixel{half, half});
    path.line_to(centre + Pixel{-half, half});
    path.close();
}

void ArrowMarks::add(Pixel foot, Pixel reach) {
    const Pixel along = 1 / length(reach) * reach;
    const Pixel tip = foot + reach, neck = tip - head_length * along;
    const Pixel side{-head_half * along.y, head_half * along.x};
    shafts_.move_to(foot);
    shafts_.line_to(neck);
    heads_.move_to(tip);
    heads_.line_to(neck + side);
    heads_.line_to(neck - side);
    heads_.close();
}

void ArrowMarks::draw(Scene& scene, Tone tone) const {
    scene.add(PathShape{shafts_, {color_of(tone), 1.2}});
    scene.add(PathShape{heads_, {{}, 1, color_of(tone)}});
}

}  // namespace batten::drawing
