#include "io/draw/axes/axes.hpp"

#include <algorithm>
#include <utility>

#include "io/draw/scene/text_layout.hpp"
#include "io/draw/scene/theme.hpp"

namespace batten::drawing {
namespace {

/// Distances of grid lines in pixels: so many in a large panel, less in a small one.
constexpr double x_spacing = 78;
constexpr double y_spacing = 44;
constexpr double least_x_spacing = 42;
constexpr double x_share = 0.16;
constexpr double y_share = 0.26;

AxisTicks ticks_on(const Frame& frame, int k, double spacing) {
    const double least = spacing * frame.units_per_pixel(k);
    const bool is_log = frame.is_log[static_cast<std::size_t>(k)];
    return is_log ? log_ticks(frame.shown(k), least) : linear_ticks(frame.shown(k), least);
}

/// The name, cut short where it is too wide, and in brackets what the numbers are multiplied by,
/// which never is.
std::string with_note(const std::string& name, const std::string& note, double width) {
    if (name.empty() || note.empty()) return shortened(name + note, label_size, width);
    const std::string behind = " (" + note + ')';
    return shortened(name, label_size, width - text_width(behind, label_size)) + behind;
}

void draw_grid(Scene& scene, const PlaneAxes& axes, const Frame& frame) {
    const Rect& area = frame.area;
    Path path;
    for (const Tick& tick : axes.x.ticks) {
        const double x = frame.on_axis(0, tick.at).x;
        path.move_to({x, area.top});
        path.line_to({x, area.bottom()});
    }
    for (const Tick& tick : axes.y.ticks) {
        const double y = frame.on_axis(1, tick.at).y;
        path.move_to({area.left, y});
        path.line_to({area.right(), y});
    }
    scene.add(PathShape{path, {grid_color, 0.8}});
    const double zero = frame.on_axis(1, 0).y;
    if (!axes.marks_zero || zero < area.top || zero > area.bottom()) return;
    Path line;
    line.move_to({area.left, zero});
    line.line_to({area.right(), zero});
    scene.add(PathShape{line, {axis_color, 1}});
}

void draw_text(Scene& scene, Pixel at, const std::string& text, Anchor anchor) {
    scene.add(TextShape{at, text, label_size, anchor, text_color});
}

void draw_numbers(Scene& scene, const PlaneAxes& axes, const Frame& frame) {
    const Rect& area = frame.area;
    if (axes.has_x_numbers) {
        for (const Tick& tick : axes.x.ticks) {
            const Pixel at{frame.on_axis(0, tick.at).x, area.bottom() + 16};
            draw_text(scene, at, tick.label, Anchor::middle);
        }
    }
    if (axes.has_y_numbers) {
        for (const Tick& tick : axes.y.ticks) {
            const Pixel at{area.left - 8, frame.on_axis(1, tick.at).y + 4};
            draw_text(scene, at, tick.label, Anchor::end);
        }
    }
}

}  // namespace

PlaneAxes plane_axes(const ReadyPanel& panel, const Frame& frame) {
    const double wide = std::clamp(x_share * frame.area.width, least_x_spacing, x_spacing);
    const double high = std::min(y_share * frame.area.height, y_spacing);
    PlaneAxes axes;
    axes.x = ticks_on(frame, 0, wide);
    axes.y = ticks_on(frame, 1, high);
    if (panel.panel->kind == PanelKind::geometry) {
        // Geometry looks best on squares, where both axes keep three lines.
        AxisTicks square = linear_ticks(frame.shown(1), axes.x.step * (1 - 1e-9));
        if (square.ticks.size() > 2) axes.y = std::move(square);
    }
    axes.marks_zero = panel.panel->kind == PanelKind::chart && !frame.is_log[1];
    const auto name = [&](const std::string& label, const std::string& note) {
        return with_note(label, note, frame.area.width);
    };
    axes.x_name = name(panel.panel->x_label, axes.x.note);
    axes.y_name = name(panel.panel->y_label, axes.y.note);
    return axes;
}

void draw_plane_axes(Scene& scene, const PlaneAxes& axes, const Frame& frame) {
    const Rect& area = frame.area;
    draw_grid(scene, axes, frame);
    draw_numbers(scene, axes, frame);
    if (axes.has_x_name()) {
        draw_text(scene, {area.right(), area.bottom() + 33}, axes.x_name, Anchor::end);
    }
    if (axes.has_y_name()) {
        const double left = std::max(margin, area.left - numbers_width);
        draw_text(scene, {left, area.top - 10}, axes.y_name, Anchor::start);
    }
}

}  // namespace batten::drawing
