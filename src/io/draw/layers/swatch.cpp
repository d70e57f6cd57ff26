#include "io/draw/layers/swatch.hpp"

#include <algorithm>

#include "io/draw/layers/map.hpp"
#include "io/draw/layers/marks.hpp"
#include "io/draw/scene/ramp.hpp"
#include "io/draw/scene/theme.hpp"

namespace batten::drawing {
namespace {

/// Bars and ticks of a chart: each run goes straight up.
bool are_upright(const std::vector<Points>& runs) {
    return !runs.empty() && std::all_of(runs.begin(), runs.end(), [](const Points& run) {
        return run.size() == 2 && run(0, 0) == run(1, 0) && run(0, 1) != run(1, 1);
    });
}

/// How a layer looks in the legend, from `left` to the right.
struct Swatch {
    Scene& scene;
    Pixel left;
    Tone tone;

    Pixel at(double share, double up) const { return left + Pixel{share * swatch_width, -up}; }

    void line(Paint paint, double up = 0) {
        Path path;
        path.move_to(at(0, up));
        path.line_to(at(1, up));
        scene.add(PathShape{path, paint});
    }

    void strokes(int gaps, Paint paint) {
        Path path;
        for (int i = 0; i <= gaps; ++i) {
            path.move_to(at(1.0 * i / gaps, -4));
            path.line_to(at(1.0 * i / gaps, 4));
        }
        scene.add(PathShape{path, paint});
    }

    void operator()(const CurveLayer& layer) { line(line_paint(layer.line, tone)); }
    void operator()(const PolylineLayer& layer) {
        const Paint paint = line_paint(layer.line, tone);
        are_upright(layer.runs) ? strokes(2, paint) : line(paint);
    }
    void operator()(const PointsLayer& layer) {
        scene.add(DotsShape{{at(0.5, 0)}, 3, dot_paint(layer.marker, tone, 3)});
    }
    void operator()(const RegionsLayer&) {
        Path patch;
        patch.move_to(at(0, -5));
        for (const Pixel corner : {at(1, -5), at(1, 5), at(0, 5)}) patch.line_to(corner);
        patch.close();
        scene.add(PathShape{patch, region_paint(tone)});
    }
    void operator()(const ControlPolygonLayer&) {
        line(leg_paint(tone));
        Path squares;
        for (const double share : {0.2, 0.8}) add_square(squares, at(share, 0), handle_half);
        scene.add(PathShape{squares, handle_paint(tone)});
    }
    void operator()(const CombLayer&) {
        strokes(4, tooth_paint(tone));
        line(envelope_paint(tone), 4);
    }
    void operator()(const ArrowsLayer&) {
        ArrowMarks arrows;
        arrows.add(left, {swatch_width, 0});
        arrows.draw(scene, tone);
    }
    void operator()(const TicksLayer&) { strokes(2, tick_paint(tone)); }
    void operator()(const TextLayer&) {}
    void operator()(const MapLayer&) {
        const Pixel corner = at(0, 5);
        draw_hatching(scene, {{corner.x, corner.y, swatch_width, 10}});
    }
    void operator()(const ColoredPointsLayer&) {}
    void operator()(const SheetLayer& layer) {
        Path patch;
        patch.move_to(at(0, -5));
        for (const Pixel corner : {at(1, -5), at(1, 5), at(0, 5)}) patch.line_to(corner);
        patch.close();
        const bool is_wire = layer.style == SheetStyle::wire;
        scene.add(PathShape{patch, {color_of(tone), is_wire ? 0.8 : 0.0,
                                    is_wire ? paper_color : shade_color(tone, shade_classes / 2)}});
    }
};

}  // namespace

void draw_swatch(Scene& scene, const LegendPlace& place) {
    std::visit(Swatch{scene, place.at - Pixel{8 + swatch_width, 4}, place.layer->tone},
               *place.layer->layer);
}

}  // namespace batten::drawing
