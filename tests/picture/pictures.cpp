#include "pictures.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace batten::testing {

Drawing points_picture() {
    Drawing drawing;
    drawing.title = "Points";
    drawing.subtitle = "Open and closed markers, corners, and numbers where there is room";
    PointsLayer open{guitar(), "open"};
    open.corners = {5, 17};
    open.labels = PointLabels::index;
    Points inner(0, 2);
    for (std::size_t i = 0; i < guitar().size(); ++i) {
        inner.push_back(std::array{0.6 * guitar()(i, 0), 0.6 * guitar()(i, 1)});
    }
    PointsLayer closed{inner, "closed", Marker::closed};
    closed.tone = Tone::blue;
    drawing.add(open).add(closed).add(TextLayer{{0, 0}, "a text beside a point"});
    return drawing;
}

Drawing outline_picture() {
    const Curve outline = hermite_chord(guitar(), Seam::smooth);
    Drawing drawing;
    drawing.title = "A free-form outline";
    drawing.add(ControlPolygonLayer{outline, "control polygon"})
        .add(CurveLayer{outline, "outline", {}})
        .add(PointsLayer{guitar(), "points given"});
    return drawing;
}

Drawing aerofoil_picture(const Points& points) {
    const Curve aerofoil = hermite_chord(points, Seam::corner);
    Drawing drawing;
    drawing.title = "RAE 2822";
    PointsLayer given{points, "points given"};
    given.corners = {0};
    drawing.add(CombLayer{aerofoil, "curvature"})
        .add(CurveLayer{aerofoil, "curve", {}})
        .add(given);
    return drawing;
}

Drawing drop_picture() {
    Drawing drawing;
    drawing.title = "A comb breaks at a corner and where the curvature jumps";
    drawing.add(CombLayer{drop(), "curvature"}).add(CurveLayer{drop(), "drop", {}});
    return drawing;
}

Drawing circle_picture() {
    const Curve circle = near_circle(1);
    Drawing drawing;
    drawing.title = "A circle of four cubics";
    drawing.add(CombLayer{circle, "curvature"})
        .add(ControlPolygonLayer{circle, "control polygon"})
        .add(CurveLayer{circle, "curve", {}});
    return drawing;
}

Drawing needle_picture() {
    const Curve needle = hermite_chord(zigzag());
    Drawing drawing;
    drawing.title = "Needles";
    drawing.subtitle = "Tangents along the chords of the neighbours, Inoue and Shibata's Table 2";
    PointsLayer points{zigzag(), "points given"};
    points.labels = PointLabels::index;
    drawing.add(CombLayer{needle, "curvature"}).add(CurveLayer{needle, "curve", {}}).add(points);
    return drawing;
}

Drawing line_picture() {
    const Points ends({-1, -1, 5, 2}, 2);
    const Curve line = hermite_chord(ends);
    const double half = line.domain().middle();
    Drawing drawing;
    drawing.title = "A straight line";
    std::vector<double> ticks;
    for (int i = 0; i <= 12; ++i) ticks.push_back(line.domain().hi * i / 12);
    ArrowsLayer arrows = tangent_arrows(line, std::array{half});
    arrows.name = "tangent";
    arrows.tone = Tone::accent;
    drawing.add(CombLayer{line, ""})
        .add(CurveLayer{line, "line", {}})
        .add(TicksLayer{line, ticks, "samples"})
        .add(arrows)
        .add(PointsLayer{ends, "ends", Marker::closed})
        .add(TextLayer{{5, 2}, "(5, 2)"});
    return drawing;
}

Drawing ruler_picture() {
    Points points(0, 2);
    for (int i = 0; i <= 20; ++i) points.push_back(std::array{i * 1.0, 0.5 * std::sin(i * 0.7)});
    Drawing drawing;
    drawing.title = "Twenty times as long as high";
    drawing.add(CurveLayer{hermite_chord(points), "", {}}).add(PointsLayer{points, ""});
    return drawing;
}

Drawing comparison_picture() {
    Drawing drawing;
    drawing.title = "The same points, two curves";
    drawing.scale = PanelScale::shared;
    drawing.panels.resize(2);
    const Curve smooth = hermite_chord(guitar(), Seam::smooth);
    Points corners = guitar();
    corners.push_back(guitar()[0]);
    drawing.panels[0].caption = "Hermite by chord direction";
    drawing.panels[0].add(CombLayer{smooth, "curvature"}).add(CurveLayer{smooth, "curve", {}});
    drawing.panels[1].caption = "Straight lines";
    drawing.panels[1].add(PolylineLayer{{corners}, "curve", {}});
    for (Panel& panel : drawing.panels) panel.add(PointsLayer{guitar(), "points"});
    return drawing;
}

Drawing convergence_picture() {
    Drawing drawing;
    drawing.title = "Error against the number of pieces";
    Panel& panel = drawing.panels[0];
    panel.kind = PanelKind::chart;
    panel.x_label = "pieces";
    panel.y_label = "largest error";
    panel.x_scale = panel.y_scale = AxisScale::log10;
    for (const int order : {2, 4, 6}) {
        Points errors(0, 2);
        for (double n = 4; n <= 512; n *= 2) {
            errors.push_back(std::array{n, 3 * std::pow(n, -order)});
        }
        const std::string name = "order " + std::to_string(order);
        panel.add(PolylineLayer{{errors}, name, {}});
        panel.add(PointsLayer{errors, ""});
    }
    return drawing;
}

Drawing curvature_picture() {
    Drawing drawing;
    drawing.title = "Curvature along an outline";
    drawing.panels[0] = curvature_plot(hermite_chord(guitar(), Seam::smooth), "Hermite");
    return drawing;
}

Drawing helix_picture() {
    Points points(0, 3);
    for (int i = 0; i <= 12; ++i) points.push_back(helix()(0.25 * std::numbers::pi * i));
    Drawing drawing;
    drawing.title = "A curve in space";
    drawing.subtitle = "With its shadow on the floor";
    drawing.add(CombLayer{helix(), "curvature"})
        .add(CurveLayer{helix(), "elliptic helix", {}})
        .add(PointsLayer{points, "points"});
    return drawing;
}

Drawing six_curves_picture() {
    Drawing drawing;
    drawing.title = "Up to six curves can be told apart";
    Panel& panel = drawing.panels[0];
    panel.kind = PanelKind::chart;
    panel.x_label = "t";
    panel.y_label = "value";
    for (int i = 1; i <= 6; ++i) {
        Points wave(0, 2);
        for (int j = 0; j <= 120; ++j) {
            wave.push_back(std::array{j / 120.0, std::sin(j / 19.0 + 0.5 * i) * (1 + 0.1 * i)});
        }
        panel.add(PolylineLayer{{wave}, "curve " + std::to_string(i), {}});
    }
    return drawing;
}

Drawing small_multiples_picture() {
    Drawing drawing;
    drawing.title = "A bump that grows";
    drawing.subtitle = "Inoue and Shibata's Table 1, y = 0 to 5";
    drawing.scale = PanelScale::shared;
    drawing.width = 900;
    drawing.panels.clear();
    for (int y = 0; y <= 5; ++y) {
        Points points(0, 2);
        for (int x = -4; x <= 4; ++x) points.push_back(std::array{x * 1.0, x == 0 ? y * 1.0 : 0});
        Panel& panel = drawing.panels.emplace_back();
        panel.caption = "y = " + std::to_string(y);
        panel.add(CurveLayer{hermite_chord(points), "Hermite by chord direction", {}})
            .add(PointsLayer{points, "points given"});
    }
    return drawing;
}

Drawing bare_picture() {
    Drawing drawing;
    drawing.width = 320;
    Panel& panel = drawing.panels[0];
    panel.axes = AxesStyle::hidden;
    LineStyle dashed{Tone::grey, Dash::dashed, 1};
    Points corners = zigzag();
    panel.add(PolylineLayer{{corners}, "", dashed}).add(CurveLayer{exact_circle(1), "", {}});
    return drawing;
}

Drawing cut_picture() {
    Drawing drawing = needle_picture();
    drawing.title = "A needle from near by";
    drawing.panels[0].x_range = Interval{0.9, 1.1};
    drawing.panels[0].y_range = Interval{-0.15, -0.05};
    return drawing;
}

Drawing joined_points(const Points& points, const std::string& title) {
    Drawing drawing;
    drawing.title = title;
    drawing.add(PolylineLayer{{points}, "line", {}}).add(PointsLayer{points, "points"});
    return drawing;
}

}  // namespace batten::testing
