#include "io/draw/layers/map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "io/draw/layers/color_bar.hpp"
#include "io/draw/scene/ramp.hpp"

namespace batten::drawing {
namespace {

constexpr double narrowest_cell = 4;  ///< pixels
constexpr double hatch_step = 7;   ///< between lines, along the edge of a box
constexpr std::string_view hatch_ground = "#f1f2f4";
constexpr std::string_view hatch_color = "#8a96a3";

/// Nodes that are drawn as one cell, and where it lies.
struct Block {
    std::size_t first = 0, last = 0;  ///< the last one excluded
    Interval part;
};

double border(const std::vector<double>& places, std::size_t node) {
    if (node == 0) return places.front();
    if (node == places.size()) return places.back();
    return 0.5 * places[node - 1] + 0.5 * places[node];
}

std::vector<Block> blocks_of(const std::vector<double>& places, std::size_t most) {
    const std::size_t count = std::min(places.size(), std::max<std::size_t>(most, 1));
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t first = i * places.size() / count;
        const std::size_t last = (i + 1) * places.size() / count;
        blocks.push_back({first, last, {border(places, first), border(places, last)}});
    }
    return blocks;
}

void add_box(Path& path, Pixel a, Pixel b) {
    path.move_to(a);
    path.line_to({b.x, a.y});
    path.line_to(b);
    path.line_to({a.x, b.y});
    path.close();
}

/// The cells with numbers, or those without.
std::vector<MapCell> cells_that(bool have_numbers, const MapLayer& map, std::size_t most_x,
                                std::size_t most_y) {
    std::vector<MapCell> cells;
    const std::vector<Block> columns = blocks_of(map.x, most_x);
    for (const Block& row : blocks_of(map.y, most_y)) {
        for (const Block& column : columns) {
            double mean = 0, count = 0;
            for (std::size_t i = column.first; i < column.last; ++i) {
                for (std::size_t j = row.first; j < row.last; ++j) {
                    if (!map.values.has(i, j)) continue;
                    count += 1;
                    mean += (map.values(i, j) - mean) / count;
                }
            }
            if ((count > 0) == have_numbers) cells.push_back({column.part, row.part, mean});
        }
    }
    return cells;
}

Rect box_between(Pixel a, Pixel b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::fabs(b.x - a.x), std::fabs(b.y - a.y)};
}

}  // namespace

std::vector<MapCell> cells_of(const MapLayer& map, std::size_t most_x, std::size_t most_y) {
    return cells_that(true, map, most_x, most_y);
}

std::vector<MapCell> gaps_of(const MapLayer& map, std::size_t most_x, std::size_t most_y) {
    if (map.values.missing() == 0) return {};
    return cells_that(false, map, most_x, most_y);
}

void draw_hatching(Scene& scene, const std::vector<Rect>& boxes) {
    Path ground, lines;
    for (const Rect& box : boxes) {
        const double right = box.right(), bottom = box.bottom();
        add_box(ground, {box.left, box.top}, {right, bottom});
        // Lines x + y = k steps.
        for (double k = std::ceil((box.left + box.top) / hatch_step);
             k * hatch_step < right + bottom; k += 1) {
            const double sum = k * hatch_step;
            const double from = std::max(box.left, sum - bottom), to = std::min(right, sum - box.top);
            lines.move_to({from, sum - from});
            lines.line_to({to, sum - to});
        }
    }
    scene.add(PathShape{std::move(ground), {hatch_ground, 0.4, hatch_ground}});
    scene.add(PathShape{std::move(lines), {hatch_color, 0.7}});
}

Interval range_of(const MapLayer& map) {
    if (map.range) return *map.range;
    Box found;
    for (std::size_t i = 0; i < map.values.nu(); ++i) {
        for (std::size_t j = 0; j < map.values.nv(); ++j) {
            const double value = map.values(i, j);
            if (map.values.has(i, j)) found.add(std::span<const double>(&value, 1));
        }
    }
    return color_range(found.sides[0], map.ramp);
}

void draw_map(Scene& scene, const MapLayer& map, const Frame& frame) {
    const auto most = [](double pixels) {
        return static_cast<std::size_t>(std::max(1.0, pixels / narrowest_cell));
    };
    const std::size_t most_x = most(frame.area.width), most_y = most(frame.area.height);
    std::vector<Rect> gaps;
    for (const MapCell& cell : gaps_of(map, most_x, most_y)) {
        gaps.push_back(box_between(frame.at(std::array{cell.x.lo, cell.y.lo}),
                                   frame.at(std::array{cell.x.hi, cell.y.hi})));
    }
    if (!gaps.empty()) draw_hatching(scene, gaps);
    const Interval range = range_of(map);
    std::array<Path, ramp_classes> paths;
    std::array<MapCell, ramp_classes> runs;  // the last cell of each class, grown along its row
    std::array<bool, ramp_classes> has_run{};
    const auto finish = [&](std::size_t k) {
        const std::array<double, 2> low{runs[k].x.lo, runs[k].y.lo}, high{runs[k].x.hi, runs[k].y.hi};
        if (has_run[k]) add_box(paths[k], frame.at(low), frame.at(high));
    };
    for (const MapCell& cell : cells_of(map, most_x, most_y)) {
        const std::size_t k =
            static_cast<std::size_t>(class_of(cell.value, range, ramp_classes));
        if (has_run[k] && runs[k].x.hi == cell.x.lo && runs[k].y == cell.y) {
            runs[k].x.hi = cell.x.hi;
            continue;
        }
        finish(k);
        runs[k] = cell;
        has_run[k] = true;
    }
    for (std::size_t k = 0; k < paths.size(); ++k) {
        finish(k);
        const std::string_view color = ramp_color(map.ramp, static_cast<int>(k));
        // A rim of its own colour closes the seams between cells.
        scene.add(PathShape{std::move(paths[k]), {color, 0.4, color}});
    }
}

}  // namespace batten::drawing
