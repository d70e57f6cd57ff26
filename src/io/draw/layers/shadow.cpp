#include "io/draw/layers/shadow.hpp"

#include "io/draw/scene/theme.hpp"
#include "io/draw/shapes/strokes.hpp"

namespace batten::drawing {
namespace {

constexpr std::size_t most_stems = 60;

Points flat(const Points& points, double floor) {
    Points result = points;
    for (std::size_t i = 0; i < result.size(); ++i) result(i, 2) = floor;
    return result;
}

void draw_stems(Scene& scene, const Points& points, const Frame& frame, double floor) {
    const std::vector<Pixel> tops = pixels_of(points, frame);
    const std::vector<Pixel> feet = pixels_of(flat(points, floor), frame);
    Path stems;
    for (std::size_t i = 0; i < tops.size(); ++i) {
        stems.move_to(tops[i]);
        stems.line_to(feet[i]);
    }
    scene.add(PathShape{stems, {shadow_color, 0.8}});
}

}  // namespace

void draw_shadow(Scene& scene, const ReadyLayer& layer, const Frame& frame, double floor) {
    Trace trace{Points(0, 3), {}};
    if (std::holds_alternative<CurveLayer>(*layer.layer)) trace = layer.trace;
    if (const auto* line = std::get_if<PolylineLayer>(layer.layer)) trace.runs = line->runs;
    trace.beziers = flat(trace.beziers, floor);
    for (Points& run : trace.runs) run = flat(run, floor);
    scene.add(PathShape{path_of(trace, frame), {shadow_color, 1.5}});
    const auto* dots = std::get_if<PointsLayer>(layer.layer);
    if (dots && dots->points.size() <= most_stems) draw_stems(scene, dots->points, frame, floor);
}

}  // namespace batten::drawing
