#include "io/draw/shapes/relief.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace batten::drawing {
namespace {

constexpr double height_share = 0.62;
constexpr double narrowest_floor = 0.5;
constexpr double relief_air = 1.06;

/// Half of side k, made positive.
double reach_of(const Box& box, std::size_t k) {
    Box side;
    side.add(std::span<const double>(&box.sides[k].lo, 1));
    side.add(std::span<const double>(&box.sides[k].hi, 1));
    return side.reach();
}

/// Half of each side as it is seen, the longer one of the floor being 1.
std::array<double, 3> seen_sides(const Box& room) {
    const double x = reach_of(room, 0), y = reach_of(room, 1), longest = std::max(x, y);
    return {std::max(x / longest, narrowest_floor), std::max(y / longest, narrowest_floor),
            height_share};
}

Pixel reach_on_paper(const std::array<double, 3>& sides) {
    return {(sides[0] + sides[1]) * isometric_x, (sides[0] + sides[1]) * isometric_y + sides[2]};
}

}  // namespace

Box relief_room(const Box& box) {
    constexpr double largest = std::numeric_limits<double>::max();
    Box room = box;
    for (std::size_t k = 0; k < 3; ++k) {
        const double half = (k == 2 ? relief_air : 1) * reach_of(box, k);
        const double middle = box.middle(static_cast<int>(k));
        room.sides[k] = {std::max(middle - half, -largest), std::min(middle + half, largest)};
    }
    return room;
}

Frame relief_frame(const Box& room, Rect area, double padding) {
    const std::array<double, 3> sides = seen_sides(room);
    const Pixel size = reach_on_paper(sides);
    const double scale = std::min((0.5 * area.width - padding) / size.x,
                                  (0.5 * area.height - padding) / size.y);
    Frame frame = space_frame(room, area, padding);
    for (std::size_t k = 0; k < 3; ++k) frame.halves[k] = reach_of(room, k);
    const double x = scale * sides[0], y = scale * sides[1];
    frame.steps = {Pixel{x * isometric_x, x * isometric_y},
                   Pixel{y * isometric_x, -y * isometric_y}, Pixel{0, -scale * sides[2]}};
    return frame;
}

double relief_aspect(const Box& room) {
    const Pixel size = reach_on_paper(seen_sides(room));
    return size.y / size.x;
}

}  // namespace batten::drawing
