#include "io/draw/layout.hpp"

#include <algorithm>
#include <cmath>

#include "io/draw/axes/ticks.hpp"
#include "io/draw/scene/text_layout.hpp"
#include "io/draw/scene/theme.hpp"
#include "io/draw/shapes/relief.hpp"

namespace batten::drawing {
namespace {

constexpr double gap = 24;  ///< between panels
/// Height over width of a panel, at least and at most.
constexpr double flattest = 0.18;
constexpr double steepest_alone = 0.78;
constexpr double steepest_beside = 1.1;
constexpr double chart_alone = 0.55;
constexpr double chart_beside = 0.72;
constexpr double lowest_panel = 110;
constexpr double narrowest_figure = 60;
constexpr double narrowest_bar = 260;
constexpr double name_height = 18;
constexpr double header_gap = 16;
constexpr double bottom_margin = 14;

/// A name in the legend and the layer that shows how it looks.
struct LegendEntry {
    std::string name;
    const ReadyLayer* layer = nullptr;
};

/// The named layers, each name once.
std::vector<LegendEntry> legend_of(const std::vector<ReadyPanel>& panels) {
    std::vector<LegendEntry> legend;
    for (const ReadyPanel& panel : panels) {
        for (const ReadyLayer& layer : panel.layers) {
            const std::string& name = name_of(*layer.layer);
            const bool known = std::any_of(legend.begin(), legend.end(), [&](const auto& entry) {
                return entry.name == name;
            });
            if (!name.empty() && !known) legend.push_back({name, &layer});
        }
    }
    return legend;
}

std::string legend_text(const LegendEntry& entry) {
    if (!std::holds_alternative<CombLayer>(*entry.layer->layer)) return entry.name;
    return entry.name + ", at most " + short_number(entry.layer->peak);
}

/// Lays out what stands above the panels; returns where they may begin.
double lay_header(Layout& layout, const Drawing& drawing, const std::vector<ReadyPanel>& panels) {
    const double width = layout.width - 2 * margin;
    layout.title = wrapped(drawing.title, title_size, width);
    layout.subtitle = wrapped(drawing.subtitle, subtitle_size, width);
    double y = margin + title_leading * static_cast<double>(layout.title.size()) +
               subtitle_leading * static_cast<double>(layout.subtitle.size());
    double x = margin;
    for (const LegendEntry& entry : legend_of(panels)) {
        const double most = width - swatch_width - 8;
        const std::string text = shortened(legend_text(entry), label_size, most);
        const double wide = swatch_width + 8 + text_width(text, label_size) + 16;
        if (x > margin && x + wide > layout.width - margin + 16) {
            x = margin;
            y += subtitle_leading;
        }
        if (layout.legend.empty()) y += subtitle_leading;
        layout.legend.push_back({{x + swatch_width + 8, y}, text, entry.layer});
        x += wide;
    }
    const bool has_header = !layout.title.empty() || !layout.subtitle.empty();
    return y + (layout.legend.empty() && !has_header ? 0 : header_gap);
}

double natural_height(const ReadyPanel& panel, double width, bool is_alone) {
    if (panel.panel->kind == PanelKind::chart) {
        return std::max(lowest_panel, width * (is_alone ? chart_alone : chart_beside));
    }
    const double rim = 2 * panel.padding + (panel.box.dim == 3 ? 2 * numbers_height : 0);
    const bool is_relief = panel.panel->kind == PanelKind::relief;
    const Box box = room_of(panel);
    const double wanted = (is_relief ? relief_aspect(box) : aspect(box)) * (width - rim) + rim;
    const double lowest = std::max(lowest_panel, flattest * width);
    return std::clamp(wanted, lowest, width * (is_alone ? steepest_alone : steepest_beside));
}

/// Room around the areas of one row of panels.
struct Rims {
    double top = 0;
    double bottom = 0;
};

bool has_axes(const ReadyPanel& panel) {
    return panel.panel->axes == AxesStyle::shown && panel.box.dim == 2;
}

Rims rims_of(const ReadyPanel& panel, const Place& place) {
    Rims rims{caption_leading * static_cast<double>(place.caption.size()), 0};
    if (!place.caption.empty()) rims.top += 4;
    if (has_axes(panel)) {
        if (place.axes.has_y_name()) rims.top += name_height;
        if (place.axes.has_x_numbers) rims.bottom += numbers_height;
        if (place.axes.has_x_name()) rims.bottom += name_height;
    }
    if (bar_of(panel)) rims.bottom += bar_room;
    return rims;
}

/// The upper left part of `cell` that a panel takes: a figure whose both ranges are asked for is
/// shown to its edges and no farther.
Rect area_in(const ReadyPanel& panel, Rect cell) {
    const Panel& asked = *panel.panel;
    if (asked.kind != PanelKind::geometry || !asked.x_range || !asked.y_range) return cell;
    const double wanted = aspect(panel.box);
    const double width = std::min(cell.width, cell.height / wanted), height = width * wanted;
    if (width < narrowest_figure || height < narrowest_figure) return cell;
    return {cell.left, cell.top, width, height};
}

/// Columns of equal areas, with room for numbers left of each or of the first.
struct Columns {
    std::size_t count = 1;
    double width = 0;  ///< of an area
    double first_left = 0;
    double step = 0;

    double left(std::size_t column) const {
        return first_left + step * static_cast<double>(column);
    }
};

Columns columns_of(const Drawing& drawing, const std::vector<ReadyPanel>& panels) {
    Columns columns;
    const std::size_t usual = panels.size() == 4 ? 2 : 3;
    const std::size_t wanted =
        drawing.columns ? static_cast<std::size_t>(*drawing.columns) : usual;
    columns.count = std::min(panels.size(), wanted);
    const double count = static_cast<double>(columns.count);
    const bool any_axes = std::any_of(panels.begin(), panels.end(), has_axes);
    const double numbers = any_axes ? numbers_width : 0;
    const double between = gap + (drawing.scale == PanelScale::shared ? 0 : numbers);
    columns.first_left = margin + numbers;
    columns.width = (drawing.width - 2 * margin - numbers - (count - 1) * between) / count;
    columns.step = columns.width + between;
    return columns;
}

}  // namespace

std::optional<ColorBar> bar_of(const ReadyPanel& panel) {
    for (const ReadyLayer& layer : panel.layers) {
        std::optional<ColorBar> bar = bar_of(*layer.layer);
        if (bar && !bar->name.empty()) return bar;
    }
    return std::nullopt;
}

Box room_of(const ReadyPanel& panel) {
    if (panel.box.dim != 3) return panel.box;
    return panel.panel->kind == PanelKind::relief ? relief_room(panel.box) : roomy(panel.box);
}

Frame frame_of(const ReadyPanel& panel, Rect area) {
    const bool is_bare = panel.panel->axes == AxesStyle::hidden;
    if (panel.box.dim == 3) {
        const double padding = is_bare ? margin : 2 * numbers_height;
        const Box room = room_of(panel);
        return panel.panel->kind == PanelKind::relief ? relief_frame(room, area, padding)
                                                      : space_frame(room, area, padding);
    }
    if (panel.panel->kind == PanelKind::chart) return chart_frame(panel.box, area, panel.is_log);
    return plane_frame(panel.box, area, panel.padding);
}

Layout layout_of(const Drawing& drawing, const std::vector<ReadyPanel>& panels) {
    Layout layout;
    layout.width = drawing.width;
    const Columns columns = columns_of(drawing, panels);
    const bool is_shared = drawing.scale == PanelScale::shared;
    double y = lay_header(layout, drawing, panels);
    for (std::size_t first = 0; first < panels.size(); first += columns.count) {
        const std::size_t last = std::min(panels.size(), first + columns.count);
        double height = 0;
        for (std::size_t i = first; i < last; ++i) {
            const double own = natural_height(panels[i], columns.width, columns.count == 1);
            height = std::max(height, own);
        }
        Rims rims;
        for (std::size_t i = first; i < last; ++i) {
            Place& place = layout.places.emplace_back();
            place.caption = wrapped(panels[i].panel->caption, caption_size, columns.width);
            place.frame = frame_of(panels[i], area_in(panels[i], {0, 0, columns.width, height}));
            place.axes = plane_axes(panels[i], place.frame);
            place.axes.has_y_numbers = !is_shared || i == first;
            place.axes.has_x_numbers = !is_shared || i + columns.count >= panels.size();
            const Rims own = rims_of(panels[i], place);
            rims = {std::max(rims.top, own.top), std::max(rims.bottom, own.bottom)};
        }
        for (std::size_t i = first; i < last; ++i) {
            Place& place = layout.places[i];
            const Rect cell{columns.left(i - first), y + rims.top, columns.width, height};
            const Rect area = area_in(panels[i], cell);
            place.bar_top = area.bottom() + rims_of(panels[i], place).bottom - bar_room + 14;
            place.bar_width = std::min(cell.width, std::max(area.width, narrowest_bar));
            place.caption_y = y + caption_size;
            place.frame = frame_of(panels[i], area);
        }
        y += rims.top + height + rims.bottom + gap;
    }
    layout.height = std::ceil(y - gap + bottom_margin);
    return layout;
}

}  // namespace batten::drawing
