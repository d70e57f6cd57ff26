#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "io/draw/compose.hpp"
#include "io/draw/scene/svg.hpp"
#include "io/draw/scene/text_layout.hpp"
#include "io/draw/shapes/frame.hpp"
#include "io/draw/shapes/strokes.hpp"
#include "pictures.hpp"
#include "random.hpp"

namespace batten::testing {
namespace drawing_law_test {

using namespace drawing;

std::vector<Drawing> all_pictures() {
    return {points_picture(),      outline_picture(),    drop_picture(),
            circle_picture(),      needle_picture(),     line_picture(),
            ruler_picture(),       comparison_picture(), convergence_picture(),
            curvature_picture(),   helix_picture(),      six_curves_picture(),
            small_multiples_picture(), bare_picture()};
}

/// Drawings of points that hardly have a size, a place or a shape.
std::vector<Drawing> odd_pictures() {
    const double ulp = std::ldexp(1, -23);  // at 1e9
    const double largest = std::numeric_limits<double>::max();
    const double smallest = std::numeric_limits<double>::denorm_min();
    const std::vector<std::vector<double>> plane{
        {3, 0, 3, 1, 3, 5, 3, 20},
        {0, 7, 1, 7},
        {3, 4},
        {0, 0},
        {-3, 4, -3, 4},
        {1e9, 1e9, 1e9 + 1e-3, 1e9 + 5e-4},
        {1e9, 0, 1e9 + ulp, ulp},
        {-12345.678, -5, -12345.677, -5.0005},
        {1e-300, 0, 2e-300, 1e-300},
        {1e300, 0, -2e300, 1e300},
        {largest, -largest, -largest, largest},
        {smallest, 0, 0, smallest},
        {1e-300, 1e300, 1, 1},
    };
    std::vector<Drawing> drawings;
    for (const auto& coordinates : plane) {
        drawings.push_back(joined_points(Points(coordinates, 2), "odd"));
        Panel& chart = drawings.emplace_back(drawings.back()).panels[0];
        chart.kind = PanelKind::chart;
    }
    const std::vector<std::vector<double>> space{
        {0, 0, 0}, {0, 0, 0, 1, 0, 0}, {1, 1, 1, 1, 1, 2}, {1e9, 0, 0, 1e9 + 1e-3, 0, 0},
        {1e300, 0, 0, -1e300, 1e300, 1e300}, {largest, 0, 0, -largest, 0, largest},
        {smallest, smallest, 0, 0, 0, 0}};
    for (const auto& coordinates : space) {
        drawings.push_back(joined_points(Points(coordinates, 3), "odd"));
    }
    return drawings;
}

Rect box_of(const TextShape& text) {
    const double width = text_width(text.text, text.size);
    const double shift = text.anchor == Anchor::middle ? 0.5 : text.anchor == Anchor::end ? 1 : 0;
    return {text.at.x - shift * width, text.at.y - 0.75 * text.size, width, text.size};
}

void expect_on_paper(const Scene& scene, const std::string& name) {
    const Rect paper{0, 0, scene.width, scene.height};
    for (const Shape& shape : scene.shapes) {
        if (const auto* path = std::get_if<PathShape>(&shape)) {
            for (const Pixel p : path->path.pixels) ASSERT_TRUE(paper.contains(p)) << name;
        }
        if (const auto* dots = std::get_if<DotsShape>(&shape)) {
            for (const Pixel p : dots->centres) ASSERT_TRUE(paper.contains(p)) << name;
        }
        if (const auto* text = std::get_if<TextShape>(&shape)) {
            const Rect box = box_of(*text);
            EXPECT_TRUE(paper.contains({box.left, box.top}) &&
                        paper.contains({box.right(), box.bottom()}))
                << name << ": " << text->text;
        }
    }
}

TEST(DrawingLaw, EverythingIsOnThePaper) {
    for (const Drawing& drawing : all_pictures()) {
        expect_on_paper(scene_of(drawing), drawing.title);
    }
}

TEST(DrawingLaw, OddPointsAreOnThePaperToo) {
    int index = 0;
    for (const Drawing& drawing : odd_pictures()) {
        const Scene scene = scene_of(drawing);
        expect_on_paper(scene, "odd picture " + std::to_string(index++));
        const std::string text = drawing::svg(scene);
        EXPECT_EQ(text.find("nan"), std::string::npos);
        EXPECT_EQ(text.find("inf"), std::string::npos);
    }
}

TEST(DrawingLaw, RandomCurvesAreOnThePaperWithAllLayers) {
    Random random(3);
    for (int trial = 0; trial < 150; ++trial) {
        Points points = random.points(static_cast<std::size_t>(random.whole(2, 12)), 2);
        const double scale = std::pow(10, random.within(-100, 100));
        const double farness = std::pow(10, random.within(-6, 10));
        for (std::size_t i = 0; i < points.size(); ++i) {
            points(i, 0) = scale * (farness + points(i, 0));
            points(i, 1) = scale * std::pow(10, random.within(-4, 0)) * points(i, 1);
        }
        const Curve curve = hermite_chord(points);
        PointsLayer dots{points, "points"};
        dots.labels = PointLabels::index;
        Drawing drawing;
        drawing.width = random.whole(240, 900);
        drawing.add(CombLayer{curve, "curvature"})
            .add(ControlPolygonLayer{curve, "handles"})
            .add(CurveLayer{curve, "curve", {}})
            .add(dots)
            .add(TicksLayer{curve, {curve.domain().middle()}, "tick"})
            .add(tangent_arrows(curve, curve.breaks()));
        expect_on_paper(scene_of(drawing), "trial " + std::to_string(trial));
    }
}

TEST(DrawingLaw, NoTextTouchesAnother) {
    std::vector<Drawing> drawings = all_pictures();
    for (const Drawing& odd : odd_pictures()) drawings.push_back(odd);
    for (const Drawing& drawing : drawings) {
        std::vector<TextShape> texts;
        for (const Shape& shape : scene_of(drawing).shapes) {
            const auto* text = std::get_if<TextShape>(&shape);
            if (text && !text->text.empty()) texts.push_back(*text);
        }
        for (std::size_t i = 0; i < texts.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const Rect a = box_of(texts[i]), b = box_of(texts[j]);
                const bool apart = a.right() < b.left || b.right() < a.left ||
                                   a.bottom() < b.top || b.bottom() < a.top;
                EXPECT_TRUE(apart) << drawing.title << ": " << texts[j].text << " and "
                                   << texts[i].text;
            }
        }
    }
}

TEST(DrawingLaw, LongTextsAreWrappedOrShortened) {
    Drawing drawing = comparison_picture();
    std::string words;
    for (int i = 0; i < 60; ++i) words += "word" + std::to_string(i) + ' ';
    drawing.title = drawing.subtitle = words + std::string(300, 'W');
    for (Panel& panel : drawing.panels) {
        panel.caption = panel.x_label = panel.y_label = words;
        panel.add(TextLayer{{1, 1}, words});
        panel.add(PolylineLayer{{guitar()}, words, {}});
    }
    expect_on_paper(scene_of(drawing), "long texts");
}

TEST(DrawingLaw, PowersOfTwoChangeNothingButTheNumbers) {
    for (const double scale : {0x1p-200, 0x1p-3, 0x1p60}) {
        Points small = guitar();
        for (double& x : small.coordinates()) x *= scale;
        std::vector<std::string> texts;
        for (const Points& points : {guitar(), small}) {
            const Curve curve = hermite_chord(points, Seam::smooth);
            Drawing drawing;
            drawing.panels[0].axes = AxesStyle::hidden;
            drawing.add(CombLayer{curve, ""}).add(CurveLayer{curve, "", {}});
            drawing.add(PointsLayer{points, ""}).add(ControlPolygonLayer{curve, ""});
            texts.push_back(svg(drawing));
        }
        EXPECT_EQ(texts[0], texts[1]);
    }
}

std::vector<Pixel> dots_of(const Scene& scene) {
    std::vector<Pixel> dots;
    for (const Shape& shape : scene.shapes) {
        const auto* some = std::get_if<DotsShape>(&shape);
        if (some) dots.insert(dots.end(), some->centres.begin(), some->centres.end());
    }
    return dots;
}

TEST(DrawingLaw, GeometryHasEqualUnitsAndYUp) {
    Drawing drawing;
    drawing.add(PointsLayer{Points({0, 0, 7, 0, 0, 3}, 2), ""});
    const std::vector<Pixel> dots = dots_of(scene_of(drawing));
    ASSERT_EQ(dots.size(), 3u);
    const double unit = (dots[1].x - dots[0].x) / 7;
    EXPECT_GT(unit, 0);
    EXPECT_NEAR(dots[0].y - dots[2].y, 3 * unit, 1e-9 * unit);
    EXPECT_NEAR(dots[1].y, dots[0].y, 1e-9 * unit);
}

TEST(DrawingLaw, SpaceIsSeenRightHandedWithEqualAxes) {
    Drawing drawing;
    drawing.add(PointsLayer{Points({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 3), ""});
    const std::vector<Pixel> dots = dots_of(scene_of(drawing));
    ASSERT_EQ(dots.size(), 4u);
    const Pixel x = dots[1] - dots[0], y = dots[2] - dots[0], z = dots[3] - dots[0];
    EXPECT_NEAR(length(x), length(y), 1e-9);
    EXPECT_NEAR(length(x), length(z), 1e-9);
    EXPECT_LT(x.x * y.y - x.y * y.x, 0);  // anticlockwise from x to y, with y down
    EXPECT_LT(z.y, 0);
}

TEST(DrawingLaw, EveryPointIsUnderADot) {
    Random random(7);
    std::vector<Pixel> centres;
    for (int i = 0; i < 20000; ++i) {
        centres.push_back({random.within(0, 90), random.within(0, 90)});
    }
    const double radius = 1.1;
    std::vector<Pixel> kept;
    for (const std::size_t i : visible_dots(centres, radius)) kept.push_back(centres[i]);
    EXPECT_LT(kept.size(), centres.size());
    for (std::size_t i = 0; i < centres.size(); i += 97) {
        double nearest = radius;
        for (const Pixel p : kept) nearest = std::min(nearest, length(p - centres[i]));
        EXPECT_LT(nearest, radius);
    }
}

TEST(DrawingLaw, DenseLinesLoseNothingThatCanBeSeen) {
    Points points(0, 2);
    for (int i = 0; i <= 100000; ++i) {
        points.push_back(std::array{i * 1e-5, 0.1 * std::sin(i * 1e-3)});
    }
    Box box;
    box.add(points);
    const Frame frame = plane_frame(box, {0, 0, 700, 300}, 14);
    const Path path = path_of(std::vector<Points>{points}, frame);
    EXPECT_LT(path.pixels.size(), 20000u);
    const std::vector<Pixel> all = pixels_of(points, frame);
    EXPECT_EQ(length(path.pixels.back() - all.back()), 0);
    std::size_t next = 0;
    for (const Pixel p : all) {  // both run in the same order
        while (next + 1 < path.pixels.size() &&
               length(path.pixels[next + 1] - p) < length(path.pixels[next] - p)) {
            ++next;
        }
        ASSERT_LT(length(path.pixels[next] - p), 0.31);
    }
}

TEST(DrawingLaw, TheSameDrawingGivesTheSameBytes) {
    for (const Drawing& drawing : all_pictures()) EXPECT_EQ(svg(drawing), svg(drawing));
}

}  // namespace drawing_law_test
}  // namespace batten::testing
