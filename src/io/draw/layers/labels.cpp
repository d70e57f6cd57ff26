#include "io/draw/layers/labels.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/draw/scene/text_layout.hpp"
#include "io/draw/scene/theme.hpp"

namespace batten::drawing {
namespace {

constexpr double cell_size = 3;
constexpr double dot_half = 2.5;  ///< a dot and its own label are 3.5 pixels apart
constexpr double halo = 2.5;

/// From one pixel towards another, of length 1, or nowhere.
Pixel towards(Pixel from, Pixel to) {
    const double size = length(to - from);
    return size > 0 ? 1 / size * (to - from) : Pixel{};
}

/// The side a polyline bends away from at point i; where it is straight, the left one.
Pixel outside(std::span<const Pixel> centres, std::size_t i) {
    const Pixel before = i > 0 ? towards(centres[i], centres[i - 1]) : Pixel{};
    const Pixel after = i + 1 < centres.size() ? towards(centres[i], centres[i + 1]) : Pixel{};
    const Pixel inward = before + after;
    if (length(inward) > 0.05) return towards(inward, {});
    const Pixel along = after - before;
    return length(along) > 0 ? towards({}, {along.y, -along.x}) : Pixel{0, -1};
}

Rect box_of(const TextShape& shape) {
    const double width = text_width(shape.text, shape.size);
    const double left = shape.at.x - (shape.anchor == Anchor::middle ? 0.5 * width
                                      : shape.anchor == Anchor::end  ? width
                                                                     : 0);
    return {left, shape.at.y - 0.78 * shape.size, width, shape.size};
}

/// Where the pieces of a path end.
std::vector<Pixel> ends_of(const Path& path) {
    std::vector<Pixel> ends;
    std::size_t next = 0;
    for (const char verb : path.verbs) {
        if (verb == 'Z') continue;
        next += verb == 'C' ? 3 : 1;
        ends.push_back(path.pixels[next - 1]);
    }
    return ends;
}

/// The place so far along a chain.
Pixel place_on(const std::vector<Pixel>& chain, double rest) {
    std::size_t i = 1;
    while (i + 1 < chain.size() && rest > length(chain[i] - chain[i - 1])) {
        rest -= length(chain[i] - chain[i - 1]);
        ++i;
    }
    return chain[i - 1] + rest * towards(chain[i - 1], chain[i]);
}

int cell(double x) { return static_cast<int>(std::floor(x / cell_size)); }

std::vector<std::pair<int, int>> cells_of(const Rect& box) {
    std::vector<std::pair<int, int>> cells;
    for (int i = cell(box.left); i <= cell(box.right()); ++i) {
        for (int j = cell(box.top); j <= cell(box.bottom()); ++j) cells.emplace_back(i, j);
    }
    return cells;
}

}  // namespace

void LabelBoard::avoid(std::span<const Pixel> centres) {
    for (const Pixel p : centres) {
        if (!area_.contains(p)) continue;
        const Rect dot{p.x - dot_half, p.y - dot_half, 2 * dot_half, 2 * dot_half};
        const std::vector<std::pair<int, int>> cells = cells_of(dot);
        taken_.insert(cells.begin(), cells.end());
    }
}

bool LabelBoard::take(const TextShape& shape) {
    const Rect box = box_of(shape);
    const bool inside = area_.contains({box.left, box.top}) &&
                        area_.contains({box.right(), box.bottom()});
    if (!inside) return false;
    const std::vector<std::pair<int, int>> cells = cells_of(box);
    for (const auto& cell : cells) {
        if (taken_.count(cell) > 0) return false;
    }
    taken_.insert(cells.begin(), cells.end());
    return true;
}

void LabelBoard::add_line(const Path& line) {
    constexpr int most_steps = 4096;  // of a chord that leaves the paper
    const std::vector<Pixel> ends = ends_of(line);
    const int id = line_count_++;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const Pixel chord = ends[i] - ends[i - 1];
        const int steps = 1 + static_cast<int>(std::min<double>(length(chord) / cell_size, most_steps));
        for (int k = 0; k <= steps; ++k) {
            const Pixel p = ends[i - 1] + (static_cast<double>(k) / steps) * chord;
            if (!area_.contains(p)) continue;
            std::vector<int>& here = lines_[{cell(p.x), cell(p.y)}];
            if (here.empty() || here.back() != id) here.push_back(id);
        }
    }
}

int LabelBoard::lines_behind(const TextShape& shape) const {
    std::set<int> found;
    for (const auto& place : cells_of(box_of(shape))) {
        const auto lines = lines_.find(place);
        if (lines != lines_.end()) found.insert(lines->second.begin(), lines->second.end());
    }
    return static_cast<int>(found.size());
}

void LabelBoard::number(Scene& scene, std::span<const Pixel> centres, double radius) {
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const Pixel side = outside(centres, i);
        for (const double sign : {1.0, -1.0}) {
            const std::string text = std::to_string(i);
            const double away = radius + 3.5 +
                                0.5 * std::fabs(side.x) * text_width(text, index_size) +
                                0.4 * std::fabs(side.y) * index_size;
            const Pixel middle = centres[i] + sign * away * side;
            TextShape shape{middle + Pixel{0, 0.36 * index_size}, text, index_size, Anchor::middle,
                            text_color};
            shape.halo = halo;
            if (!take(shape)) continue;
            scene.add(shape);
            break;
        }
    }
}

void LabelBoard::write_upon(Scene& scene, const Path& line, const std::string& text,
                            std::string_view color) {
    constexpr double shortest_line = 4;  // in widths of the text
    const std::vector<Pixel> ends = ends_of(line);
    double whole = 0;
    for (std::size_t i = 1; i < ends.size(); ++i) whole += length(ends[i] - ends[i - 1]);
    if (whole < shortest_line * text_width(text, index_size)) return;
    // Its own line is one of those behind it.
    for (const int most_lines : {1, 2}) {
        for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8, 0.28, 0.72, 0.42, 0.58, 0.1, 0.9}) {
            const Pixel at = place_on(ends, share * whole);
            TextShape shape{at + Pixel{0, 0.36 * index_size}, text, index_size, Anchor::middle,
                            color};
            shape.halo = halo;
            if (lines_behind(shape) > most_lines || !take(shape)) continue;
            scene.add(shape);
            return;
        }
    }
}

void LabelBoard::write(Scene& scene, Pixel at, const std::string& whole, std::string_view color) {
    if (!area_.contains(at)) return;
    const std::string text = shortened(whole, label_size, area_.width);
    const double up = -8, down = 8 + 0.7 * label_size;
    std::vector<TextShape> tries;
    for (const double y : {up, down}) {
        tries.push_back({at + Pixel{7, y}, text, label_size, Anchor::start, color});
        tries.push_back({at + Pixel{-7, y}, text, label_size, Anchor::end, color});
        tries.push_back({at + Pixel{0, y}, text, label_size, Anchor::middle, color});
    }
    for (TextShape& shape : tries) {
        shape.halo = halo;
        if (!take(shape)) continue;
        scene.add(shape);
        return;
    }
    const double room = std::max(0.0, area_.width - text_width(text, label_size));
    TextShape& last = tries.front();
    last.at.x = std::clamp(last.at.x, area_.left, area_.left + room);
    scene.add(last);
}

}  // namespace batten::drawing
