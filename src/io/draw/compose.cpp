#include "io/draw/compose.hpp"

#include "io/draw/axes/axes.hpp"
#include "io/draw/layers/color_bar.hpp"
#include "io/draw/layers/paint.hpp"
#include "io/draw/layers/swatch.hpp"
#include "io/draw/layout.hpp"
#include "io/draw/scene/svg.hpp"
#include "io/draw/scene/theme.hpp"

namespace batten::drawing {
namespace {

void draw_header(Scene& scene, const Layout& layout) {
    double y = margin - 6;
    for (const std::string& line : layout.title) {
        y += title_leading;
        scene.add(TextShape{{margin, y}, line, title_size, Anchor::start, ink_color, Weight::bold});
    }
    for (const std::string& line : layout.subtitle) {
        y += subtitle_leading;
        scene.add(TextShape{{margin, y}, line, subtitle_size, Anchor::start, text_color});
    }
    for (const LegendPlace& entry : layout.legend) {
        draw_swatch(scene, entry);
        scene.add(TextShape{entry.at, entry.text, label_size, Anchor::start, text_color});
    }
}

void draw_panel(Scene& scene, const ReadyPanel& panel, const Place& place) {
    double y = place.caption_y;
    for (const std::string& line : place.caption) {
        scene.add(TextShape{{place.frame.area.left, y}, line, caption_size, Anchor::start,
                            ink_color, Weight::bold});
        y += caption_leading;
    }
    const bool has_axes = panel.panel->axes == AxesStyle::shown;
    const Box room = room_of(panel);
    if (has_axes && panel.box.dim == 3) draw_space_axes(scene, *panel.panel, place.frame, room);
    if (has_axes && panel.box.dim == 2) draw_plane_axes(scene, place.axes, place.frame);
    draw_layers(scene, panel, place.frame, room);
    const Rect& area = place.frame.area;
    if (const std::optional<ColorBar> bar = bar_of(panel)) {
        draw_bar(scene, *bar, {area.left, place.bar_top}, place.bar_width);
    }
}

std::string description_of(const Drawing& drawing) {
    if (!drawing.description.empty()) return drawing.description;
    std::string text = std::to_string(drawing.panels.size()) +
                       (drawing.panels.size() == 1 ? " panel" : " panels");
    std::string shown;
    for (const Panel& panel : drawing.panels) {
        if (!panel.caption.empty()) shown += (shown.empty() ? ": " : "; ") + panel.caption;
        for (const Layer& layer : panel.layers) {
            const std::string& name = name_of(layer);
            if (!name.empty()) shown += (shown.empty() ? ": " : ", ") + name;
        }
    }
    return text + shown + '.';
}

}  // namespace

Scene scene_of(const Drawing& drawing) {
    const std::vector<ReadyPanel> panels = prepare(drawing);
    const Layout layout = layout_of(drawing, panels);
    Scene scene{layout.width, layout.height, drawing.title, description_of(drawing), {}};
    draw_header(scene, layout);
    for (std::size_t i = 0; i < panels.size(); ++i) {
        draw_panel(scene, panels[i], layout.places[i]);
    }
    return scene;
}

}  // namespace batten::drawing

namespace batten {

std::string svg(const Drawing& drawing) { return drawing::svg(drawing::scene_of(drawing)); }

}  // namespace batten
