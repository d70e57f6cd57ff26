#pragma once

#include <set>
#include <span>
#include <string>
#include <utility>

#include "io/draw/scene/scene.hpp"

namespace batten::drawing {

/// Puts texts beside points so that they neither leave an area nor cross one another.
class LabelBoard {
public:
    explicit LabelBoard(Rect area) : area_(area) {}

    /// Keeps labels off these dots.
    void avoid(std::span<const Pixel> centres);

    /// Numbers the points on their outer side. Those without room are left out.
    void number(Scene& scene, std::span<const Pixel> centres, double radius);

    /// A text above the right of a point, or where else there is room; drawn wherever the point is
    /// inside the area, shortened to the area's width.
    void write(Scene& scene, Pixel at, const std::string& whole, std::string_view color);

    /// A text upon a line, in its middle or where else there is room; left out where the line is
    /// short or its pieces leave no room.
    void write_upon(Scene& scene, const Path& line, const std::string& text,
                    std::string_view color);

private:
    bool take(const TextShape& shape);

    Rect area_;
    std::set<std::pair<int, int>> taken_;
};

}  // namespace batten::drawing
