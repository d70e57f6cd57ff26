#include "io/draw/layers/colored_dots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <unordered_map>

#include "io/draw/layers/color_bar.hpp"
#include "io/draw/scene/ramp.hpp"
#include "io/draw/scene/theme.hpp"

namespace batten::drawing {
namespace {

// Pixels.
constexpr double closest = 4;  ///< dots in a square of this side are drawn as one
constexpr double least_radius = 1.8, largest_radius = 3.4;
constexpr double radius_share = 0.3;  ///< of the mean distance between dots
constexpr double rim_width = 0.6;     ///< else those around 0 would be paper on paper

struct Dot {
    Pixel at;
    double value = 0, count = 0;

    void add(Pixel place, double number) {
        count += 1;
        at = at + (1 / count) * (place - at);
        value += (number - value) / count;
    }
};

/// Means of what stands close together, in the order in which they first came.
std::vector<Dot> merged(const ColoredPointsLayer& layer, const Frame& frame) {
    std::vector<Dot> dots;
    std::unordered_map<std::int64_t, std::size_t> places;
    for (std::size_t i = 0; i < layer.points.size(); ++i) {
        const Pixel at = frame.at(layer.points[i]);
        const auto square = [](double x) {
            constexpr double farthest = 1e5;  // cut pictures may hold dots far outside
            return std::llround(std::clamp(x, -farthest, farthest) / closest);
        };
        const std::int64_t key = square(at.x) * (std::int64_t{1} << 32) + square(at.y);
        const auto [place, is_new] = places.emplace(key, dots.size());
        if (is_new) dots.emplace_back();
        dots[place->second].add(at, layer.values[i]);
    }
    return dots;
}

double radius_of(const std::vector<Dot>& dots) {
    Box part;
    for (const Dot& dot : dots) part.add(std::array{dot.at.x, dot.at.y});
    const double area = part.sides[0].length() * part.sides[1].length();
    return std::clamp(radius_share * std::sqrt(area / static_cast<double>(dots.size())),
                      least_radius, largest_radius);
}

/// Classes from the most usual to the ends of the ramp, so that the latter lie on top.
std::array<int, ramp_classes> outward(Ramp ramp) {
    std::array<int, ramp_classes> order;
    for (int k = 0; k < ramp_classes; ++k) order[static_cast<std::size_t>(k)] = k;
    if (ramp == Ramp::diverging) {
        std::stable_sort(order.begin(), order.end(), [](int a, int b) {
            return std::abs(a - ramp_classes / 2) < std::abs(b - ramp_classes / 2);
        });
    }
    return order;
}

}  // namespace

Interval range_of(const ColoredPointsLayer& layer) {
    if (layer.range) return *layer.range;
    const auto [least, most] = std::minmax_element(layer.values.begin(), layer.values.end());
    return color_range({*least, *most}, layer.ramp);
}

void draw_colored_dots(Scene& scene, const ColoredPointsLayer& layer, const Frame& frame) {
    const std::vector<Dot> dots = merged(layer, frame);
    const double radius = radius_of(dots);
    const Interval range = range_of(layer);
    std::array<std::vector<Pixel>, ramp_classes> classes;
    for (const Dot& dot : dots) {
        const int which = class_of(dot.value, range, ramp_classes);
        classes[static_cast<std::size_t>(which)].push_back(dot.at);
    }
    for (const int k : outward(layer.ramp)) {
        std::vector<Pixel>& centres = classes[static_cast<std::size_t>(k)];
        if (centres.empty()) continue;
        scene.add(DotsShape{std::move(centres), radius,
                            {axis_color, rim_width, ramp_color(layer.ramp, k)}});
    }
}

}  // namespace batten::drawing
