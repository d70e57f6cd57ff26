#include "io/draw/layers/paint.hpp"

#include "io/draw/layers/colored_dots.hpp"
#include "io/draw/layers/labels.hpp"
#include "io/draw/layers/map.hpp"
#include "io/draw/layers/marks.hpp"
#include "io/draw/layers/shadow.hpp"
#include "io/draw/layers/sheet.hpp"
#include "io/draw/scene/theme.hpp"
#include "io/draw/shapes/strokes.hpp"

namespace batten::drawing {
namespace {

constexpr double corner_share = 1.25;  ///< half the side of a corner's square, in dot radii

struct Painter {
    Scene& scene;
    const Frame& frame;
    LabelBoard& labels;
    const ReadyLayer& ready;

    std::string_view color() const { return color_of(ready.tone); }
    void stroke(Path path, Paint paint) { scene.add(PathShape{std::move(path), paint}); }

    void operator()(const CurveLayer& layer) {
        stroke(path_of(ready.trace, frame), line_paint(layer.line, ready.tone));
    }

    void operator()(const PolylineLayer& layer) {
        stroke(path_of(layer.runs, frame), line_paint(layer.line, ready.tone));
    }

    void operator()(const PointsLayer& layer) {
        const std::vector<Pixel> centres = pixels_of(layer.points, frame);
        const double radius = dot_radius(centres);
        std::vector<char> is_corner(centres.size(), 0);
        for (const int i : layer.corners) is_corner[static_cast<std::size_t>(i)] = 1;
        DotsShape dots{{}, radius, dot_paint(layer.marker, ready.tone, radius)};
        Path corners;
        for (const std::size_t i : visible_dots(centres, radius)) {
            if (is_corner[i] == 0) dots.centres.push_back(centres[i]);
        }
        for (std::size_t i = 0; i < centres.size(); ++i) {
            if (is_corner[i] != 0) add_square(corners, centres[i], corner_share * radius);
        }
        scene.add(std::move(dots));
        stroke(corners, {paper_color, 1, color_of(Tone::accent)});
        if (layer.labels == PointLabels::index) labels.number(scene, centres, radius);
    }

    void operator()(const RegionsLayer& layer) {
        Path path;
        for (const Points& outline : layer.outlines) {
            const Path ring = path_of(std::vector<Points>{outline}, frame);
            path.verbs += ring.verbs;
            path.pixels.insert(path.pixels.end(), ring.pixels.begin(), ring.pixels.end());
            path.close();
        }
        stroke(path, region_paint(ready.tone));
    }

    void operator()(const ControlPolygonLayer&) {
        Path legs, squares;
        const std::vector<Pixel> controls = pixels_of(ready.trace.beziers, frame);
        for (std::size_t i = 0; i < controls.size(); i += 4) {
            const Pixel reach = controls[i + 3] - controls[i];
            if (length(reach) + length(controls[i + 1] - controls[i]) < 1) continue;
            for (std::size_t j = 0; j < 4; ++j) {
                j == 0 ? legs.move_to(controls[i]) : legs.line_to(controls[i + j]);
            }
            add_square(squares, controls[i + 1], handle_half);
            add_square(squares, controls[i + 2], handle_half);
        }
        stroke(legs, leg_paint(ready.tone));
        stroke(squares, handle_paint(ready.tone));
    }

    void operator()(const CombLayer&) {
        Path teeth;
        const Points& rows = ready.comb.teeth;
        for (std::size_t i = 0; i < rows.size(); i += 2) {
            const Pixel foot = frame.at(rows[i]), tip = frame.at(rows[i + 1]);
            if (length(tip - foot) < 0.3) continue;
            teeth.move_to(foot);
            teeth.line_to(tip);
        }
        stroke(teeth, tooth_paint(ready.tone));
        stroke(path_of(ready.comb.envelope, frame), envelope_paint(ready.tone));
    }

    void operator()(const ArrowsLayer& layer) {
        ArrowMarks arrows;
        for (std::size_t i = 0; i < layer.at.size(); ++i) {
            const Pixel along = frame.along(layer.directions[i]);
            if (length(along) > 0) arrows.add(frame.at(layer.at[i]), arrow_length * along);
        }
        arrows.draw(scene, ready.tone);
    }

    void operator()(const TicksLayer& layer) {
        Path path;
        for (const double t : layer.at) {
            const Jet jet = layer.curve.jet(t, 1);
            const Pixel along = frame.along(jet[1]), at = frame.at(jet[0]);
            const Pixel half = 0.5 * tick_length * Pixel{-along.y, along.x};
            path.move_to(at - half);
            path.line_to(at + half);
        }
        stroke(path, tick_paint(ready.tone));
    }

    void operator()(const TextLayer& layer) {
        labels.write(scene, frame.at(layer.at), layer.text, color());
    }

    void operator()(const MapLayer& layer) { draw_map(scene, layer, frame); }
    void operator()(const ColoredPointsLayer& layer) { draw_colored_dots(scene, layer, frame); }
    void operator()(const SheetLayer& layer) { draw_sheet(scene, layer, frame); }
};

/// A line that carries a text.
struct LabelledLine {
    Path path;
    const std::string& text;
    std::string_view color;
};

std::vector<LabelledLine> labelled_lines(const ReadyPanel& panel, const Frame& frame) {
    std::vector<LabelledLine> found;
    for (const ReadyLayer& ready : panel.layers) {
        const std::string_view color = color_of(ready.tone);
        if (const auto* curve = std::get_if<CurveLayer>(ready.layer)) {
            if (curve->label.empty()) continue;
            found.push_back({path_of(ready.trace, frame), curve->label, color});
        }
        if (const auto* lines = std::get_if<PolylineLayer>(ready.layer)) {
            if (lines->label.empty()) continue;
            for (const Points& run : lines->runs) {
                found.push_back({path_of(std::vector<Points>{run}, frame), lines->label, color});
            }
        }
    }
    return found;
}

void write_upon_lines(Scene& scene, const ReadyPanel& panel, const Frame& frame,
                      LabelBoard& labels) {
    const std::vector<LabelledLine> lines = labelled_lines(panel, frame);
    for (const LabelledLine& line : lines) labels.add_line(line.path);
    for (const LabelledLine& line : lines) {
        labels.write_upon(scene, line.path, line.text, line.color);
    }
}

}  // namespace

void draw_layers(Scene& scene, const ReadyPanel& panel, const Frame& frame, const Box& room) {
    for (const ReadyLayer& layer : panel.layers) {
        if (room.dim == 3) draw_shadow(scene, layer, frame, room.sides[2].lo);
    }
    LabelBoard labels(frame.area);
    for (const ReadyLayer& layer : panel.layers) {
        const auto* dots = std::get_if<PointsLayer>(layer.layer);
        if (dots) labels.avoid(pixels_of(dots->points, frame));
    }
    if (panel.is_cut) scene.add(ClipStart{frame.area});
    for (const ReadyLayer& layer : panel.layers) {
        std::visit(Painter{scene, frame, labels, layer}, *layer.layer);
    }
    write_upon_lines(scene, panel, frame, labels);
    if (panel.is_cut) scene.add(ClipEnd{});
}

}  // namespace batten::drawing
