#include "io/draw/shapes/frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace batten::drawing {
namespace {

std::size_t index(int k) { return static_cast<std::size_t>(k); }

/// (x - middle) / half, halved first: the difference of two doubles may be none. What lies far
/// outside of a cut picture is brought to where it still is outside.
double steps_from(double x, double middle, double half) {
    constexpr double farthest = 1e9;
    return std::clamp((0.5 * x - 0.5 * middle) / (0.5 * half), -farthest, farthest);
}

/// How far the isometric picture of a box reaches from its middle.
Pixel isometric_reach(const Box& box, double reach) {
    const double sides = box.half(0) / reach + box.half(1) / reach;
    return {sides * isometric_x, sides * isometric_y + box.half(2) / reach};
}

}  // namespace

void Box::add(std::span<const double> point) {
    for (std::size_t k = 0; k < point.size(); ++k) {
        sides[k] = dim == 0 ? Interval{point[k], point[k]}
                            : Interval{std::min(sides[k].lo, point[k]),
                                       std::max(sides[k].hi, point[k])};
    }
    dim = static_cast<int>(point.size());
}

void Box::add(PointsView points) {
    for (std::size_t i = 0; i < points.size(); ++i) add(points[i]);
}

void Box::add(const Box& other) {
    if (other.dim == 0) return;
    std::array<double, 3> corner{};
    for (const bool low : {true, false}) {
        for (std::size_t k = 0; k < 3; ++k) {
            corner[k] = low ? other.sides[k].lo : other.sides[k].hi;
        }
        add({corner.data(), index(other.dim)});
    }
}

double Box::middle(int k) const { return 0.5 * side(k).lo + 0.5 * side(k).hi; }

double Box::half(int k) const { return 0.5 * side(k).hi - 0.5 * side(k).lo; }

double Box::reach() const {
    constexpr double few_ulps = 64 * std::numeric_limits<double>::epsilon();
    double longest = 0, farthest = 0;
    for (int k = 0; k < dim; ++k) {
        longest = std::max(longest, half(k));
        farthest = std::max(farthest, std::fabs(middle(k)));
    }
    if (longest == 0) longest = farthest == 0 ? 1 : 0.1 * farthest;
    return std::max({longest, few_ulps * farthest, 8 * std::numeric_limits<double>::min()});
}

Pixel Frame::at(std::span<const double> point) const {
    Pixel p = origin;
    for (std::size_t k = 0; k < point.size(); ++k) {
        const double x = is_log[k] ? std::log10(point[k]) : point[k];
        p = p + steps_from(x, middle[k], halves[k]) * steps[k];
    }
    return p;
}

std::array<double, 3> Frame::along_axes(const std::array<double, 3>& point) const {
    std::array<double, 3> pixels{};
    for (std::size_t k = 0; k < 3; ++k) {
        pixels[k] = steps_from(point[k], middle[k], halves[k]) * length(steps[k]);
    }
    return pixels;
}

Pixel Frame::along(std::span<const double> direction) const {
    double largest = 0;
    for (const double x : direction) largest = std::max(largest, std::fabs(x));
    if (largest == 0) return {};
    Pixel p;
    for (std::size_t k = 0; k < direction.size(); ++k) {
        p = p + direction[k] / largest * (halves[0] / halves[k]) * steps[k];
    }
    const double size = length(p);
    return size > 0 ? 1 / size * p : Pixel{};
}

Pixel Frame::on_axis(int k, double x) const {
    return origin + steps_from(x, middle[index(k)], halves[index(k)]) * steps[index(k)];
}

Interval Frame::shown(int k) const {
    const double from = k == 0 ? (area.left - origin.x) / steps[0].x
                               : (area.bottom() - origin.y) / steps[1].y;
    const double to = k == 0 ? (area.right() - origin.x) / steps[0].x
                             : (area.top - origin.y) / steps[1].y;
    constexpr double largest = std::numeric_limits<double>::max();
    const double half = halves[index(k)], centre = middle[index(k)];
    return {std::clamp(centre + from * half, -largest, largest),
            std::clamp(centre + to * half, -largest, largest)};
}

double Frame::units_per_pixel(int k) const {
    return halves[index(k)] / length(steps[index(k)]);
}

Frame plane_frame(const Box& box, Rect area, double padding) {
    const double reach = box.reach();
    const double wide = box.half(0) / reach, high = box.half(1) / reach;
    const double across = 0.5 * area.width - padding, up = 0.5 * area.height - padding;
    const bool is_point = std::max(wide, high) < 1;
    const bool fills_width = is_point ? across < up : up * wide > across * high;
    const double scale = fills_width ? across / (is_point ? 1 : wide) : up / (is_point ? 1 : high);
    Frame frame;
    frame.area = area;
    frame.origin = {area.left + 0.5 * area.width, area.top + 0.5 * area.height};
    frame.middle = {box.middle(0), box.middle(1), 0};
    frame.halves = {reach, reach, reach};
    frame.steps = {Pixel{scale, 0}, Pixel{0, -scale}, Pixel{}};
    return frame;
}

Box roomy(const Box& box) {
    constexpr double largest = std::numeric_limits<double>::max();
    Box result = box;
    const double reach = box.reach();
    for (int k = 0; k < 3; ++k) {
        const double half = std::max(1.08 * box.half(k), 0.06 * reach);
        result.sides[index(k)] = {std::max(box.middle(k) - half, -largest),
                                  std::min(box.middle(k) + half, largest)};
    }
    return result;
}

Frame space_frame(const Box& box, Rect area, double padding) {
    const double reach = box.reach();
    const Pixel size = isometric_reach(box, reach);
    const double scale = std::min((0.5 * area.width - padding) / size.x,
                                  (0.5 * area.height - padding) / size.y);
    Frame frame = plane_frame(box, area, padding);
    frame.dim = 3;
    frame.middle[2] = box.middle(2);
    frame.steps = {Pixel{scale * isometric_x, scale * isometric_y},
                   Pixel{scale * isometric_x, -scale * isometric_y}, Pixel{0, -scale}};
    return frame;
}

Frame chart_frame(const Box& box, Rect area, std::array<bool, 3> is_log) {
    Frame frame = plane_frame(box, area, 0);
    frame.is_log = is_log;
    for (int k = 0; k < 2; ++k) {
        Box side;
        side.add(std::span<const double>(&box.sides[index(k)].lo, 1));
        side.add(std::span<const double>(&box.sides[index(k)].hi, 1));
        frame.halves[index(k)] = side.reach();
    }
    frame.steps[0] = {0.5 * area.width, 0};
    frame.steps[1] = {0, -0.5 * area.height};
    return frame;
}

double aspect(const Box& box) {
    const double reach = box.reach();
    if (box.dim == 3) {
        const Pixel size = isometric_reach(box, reach);
        return size.y / size.x;
    }
    const double wide = box.half(0) / reach, high = box.half(1) / reach;
    if (std::max(wide, high) < 1) return 0.5;
    constexpr double steepest = 1e3;
    return high > steepest * wide ? steepest : high / wide;
}

}  // namespace batten::drawing
