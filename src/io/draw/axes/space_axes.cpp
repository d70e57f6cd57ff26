#include <array>

#include "io/draw/axes/axes.hpp"
#include "io/draw/axes/ticks.hpp"
#include "io/draw/scene/theme.hpp"

namespace batten::drawing {
namespace {

/// Least distances of grid lines, in pixels.
constexpr double spacing = 46;
constexpr double relief_z_spacing = 26;

std::array<std::string, 3> names_of(const Panel& panel) {
    std::array<std::string, 3> names{"x", "y", "z"};
    if (!panel.x_label.empty()) names[0] = panel.x_label;
    if (!panel.y_label.empty()) names[1] = panel.y_label;
    if (!panel.z_label.empty()) names[2] = panel.z_label;
    return names;
}

/// The ends of the box that one sees the inside of: x low, y high, z low.
double back(const Box& box, std::size_t k) { return k == 1 ? box.sides[k].hi : box.sides[k].lo; }
double front(const Box& box, std::size_t k) { return k == 1 ? box.sides[k].lo : box.sides[k].hi; }

/// Lines at coordinate k = `at` on the two back walls that k runs along.
void add_lines(Path& path, const Frame& frame, const Box& box, std::size_t k, double at) {
    for (const std::size_t along : {(k + 1) % 3, (k + 2) % 3}) {
        std::array<double, 3> corner{back(box, 0), back(box, 1), back(box, 2)};
        corner[k] = at;
        path.move_to(frame.at(corner));
        corner[along] = front(box, along);
        path.line_to(frame.at(corner));
    }
}

/// Where the numbers of coordinate k stand: on the edge of the silhouette that k runs along.
std::array<double, 3> edge(const Box& box, std::size_t k, double at) {
    std::array<double, 3> corner{back(box, 0), back(box, 1), back(box, 2)};
    if (k == 0) corner[1] = front(box, 1);
    if (k == 1) corner[0] = front(box, 0);
    if (k == 2) corner[1] = front(box, 1);
    corner[k] = at;
    return corner;
}

struct EdgeStyle {
    Pixel offset;
    Pixel name_offset;
    Anchor anchor;
};

/// Numbers left and below for x, right and below for y, left for z.
constexpr std::array<EdgeStyle, 3> edge_styles{
    EdgeStyle{{-7, 13}, {-26, 30}, Anchor::end}, EdgeStyle{{7, 13}, {26, 30}, Anchor::start},
    EdgeStyle{{-9, 4}, {-9, -14}, Anchor::end}};

}  // namespace

void draw_space_axes(Scene& scene, const Panel& panel, const Frame& frame, const Box& box) {
    const std::array<std::string, 3> names = names_of(panel);
    Path grid, walls;
    std::string notes;
    for (std::size_t k = 0; k < 3; ++k) {
        const int axis = static_cast<int>(k);
        const Interval side = box.sides[k];
        const bool is_low = k == 2 && panel.kind == PanelKind::relief;
        const double least = is_low ? relief_z_spacing : spacing;
        const AxisTicks ticks = linear_ticks(side, least * frame.units_per_pixel(axis));
        const EdgeStyle& style = edge_styles[k];
        for (const Tick& tick : ticks.ticks) {
            add_lines(grid, frame, box, k, tick.at);
            scene.add(TextShape{frame.at(edge(box, k, tick.at)) + style.offset, tick.label,
                                label_size, style.anchor, text_color});
        }
        for (const double end : {side.lo, side.hi}) add_lines(walls, frame, box, k, end);
        const double name_at = k == 2 ? side.hi : box.middle(axis);
        scene.add(TextShape{frame.at(edge(box, k, name_at)) + style.name_offset, names[k],
                            label_size, style.anchor, ink_color, Weight::bold});
        if (ticks.note.empty()) continue;
        notes += (notes.empty() ? "" : ", ") + names[k] + ": " + ticks.note;
    }
    const Pixel corner{frame.area.left, frame.area.bottom() - 4};
    scene.add(TextShape{corner, notes, label_size, Anchor::start, text_color});
    scene.add(PathShape{grid, {grid_color, 0.8}});
    scene.add(PathShape{walls, {axis_color, 0.8}});
}

}  // namespace batten::drawing
