#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

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

    /// A line that carries a text, or may: others are not written where it goes.
    void add_line(const Path& line);

    /// A text upon a line that was added, in its middle or where else there is room and no other
    /// line, or at most one; left out where the line is short or there is no such place.
    void write_upon(Scene& scene, const Path& line, const std::string& text,
                    std::string_view color);

private:
    bool take(const TextShape& shape);
    int lines_behind(const TextShape& shape) const;

    Rect area_;
    std::set<std::pair<int, int>> taken_;
    std::map<std::pair<int, int>, std::vector<int>> lines_;  ///< those that go through a cell
    int line_count_ = 0;
};

}  // namespace batten::drawing
