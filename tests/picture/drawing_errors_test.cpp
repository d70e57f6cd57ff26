#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "batten/base/error.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "io/draw/scene/svg.hpp"
#include "errors.hpp"
#include "pictures.hpp"

namespace batten::testing {
namespace drawing_errors_test {

/// What `svg` says of a good drawing that `spoil` has changed: id and place.
std::string complaint(const std::function<void(Drawing&)>& spoil) {
    Drawing drawing;
    drawing.add(CurveLayer{near_circle(1), "circle", {}});
    spoil(drawing);
    return code_and_place_of([&] { svg(drawing); });
}

Points points(std::vector<double> coordinates) { return Points(std::move(coordinates), 2); }

TEST(DrawingErrors, SayWhatIsEmpty) {
    EXPECT_EQ(complaint([](Drawing& d) { d.panels.clear(); }), "drawing.empty drawing");
    EXPECT_EQ(complaint([](Drawing& d) { d.panels.emplace_back(); }), "drawing.empty panel 1");
    EXPECT_EQ(complaint([](Drawing& d) {
                  d.panels[0].layers = {PointsLayer{points({}), "none"}};
              }),
              "drawing.empty panel 0");
}

TEST(DrawingErrors, SayWhichNumberIsNotFinite) {
    EXPECT_EQ(complaint([](Drawing& d) { d.add(PointsLayer{points({0, 0, nan, 1}), ""}); }),
              "points.not-finite panel 0 layer 1 point 1, coordinate 0");
    EXPECT_EQ(complaint([](Drawing& d) { d.add(TextLayer{{0, inf}, "far"}); }),
              "points.not-finite panel 0 layer 1 point 0, coordinate 1");
    EXPECT_EQ(complaint([](Drawing& d) {
                  d.add(ArrowsLayer{points({0, 0}), points({-inf, 1}), ""});
              }),
              "points.not-finite panel 0 layer 1 point 0, coordinate 0");
}

TEST(DrawingErrors, SayWhereACurveIsNotFinite) {
    const auto pole = [](double t, int order, std::span<double> out) {
        for (double& x : out) x = 0;
        out[0] = 1 / t;
        if (order > 0) out[2] = -1 / (t * t);
    };
    const Curve curve = CallableCurve{pole, 2, {-1, 1}, false};
    EXPECT_EQ(complaint([&](Drawing& d) { d.add(CurveLayer{curve, "", {}}); }),
              "drawing.not-finite curve at t = 0");
    EXPECT_EQ(complaint([&](Drawing& d) { d.add(TicksLayer{curve, {0}, ""}); }),
              "drawing.not-finite curve at t = 0");
    const Curve steep = PiecewiseCubic::hermite(points({0, 0, 1, 0}), points({1e300, 0}),
                                                points({1, 0}), {0, 1e100}, false);
    EXPECT_EQ(complaint([&](Drawing& d) { d.add(CurveLayer{steep, "", {}}); }),
              "number.overflow piece 0");
}

TEST(DrawingErrors, SayWhichLayerHasAnotherDimension) {
    EXPECT_EQ(complaint([](Drawing& d) { d.add(CurveLayer{helix(), "", {}}); }),
              "drawing.dimension panel 0 layer 1");
    EXPECT_EQ(complaint([](Drawing& d) { d.add(PointsLayer{Points({1, 2}, 1), ""}); }),
              "drawing.dimension panel 0 layer 1");
    EXPECT_EQ(complaint([](Drawing& d) {
                  d.panels[0].kind = PanelKind::chart;
                  d.panels[0].layers = {CurveLayer{helix(), "", {}}};
              }),
              "drawing.dimension panel 0 layer 0");
    const auto line = [](double t, int, std::span<double> out) { out[0] = t; };
    EXPECT_EQ(code_of([&] { curvature_plot(CallableCurve{line, 1, {0, 1}, false}); }),
              "drawing.dimension");
}

TEST(DrawingErrors, SayWhatALogarithmicAxisCannotShow) {
    const auto log_chart = [](Drawing& d) {
        d.panels[0].layers.clear();
        d.panels[0].kind = PanelKind::chart;
        d.panels[0].y_scale = AxisScale::log10;
    };
    EXPECT_EQ(complaint([&](Drawing& d) {
                  log_chart(d);
                  d.add(PolylineLayer{{points({-1, 1, 2, 0})}, "", {}});
              }),
              "drawing.not-positive panel 0 layer 0 point 1");
    EXPECT_EQ(complaint([&](Drawing& d) {
                  log_chart(d);
                  d.add(CurveLayer{near_circle(1), "", {}});
              }),
              "drawing.option panel 0 layer 0");
    EXPECT_EQ(complaint([&](Drawing& d) {
                  log_chart(d);
                  d.add(PolylineLayer{{points({1, 1, 2, 2})}, "", {}});
                  d.panels[0].y_range = Interval{0, 1};
              }),
              "drawing.option panel 0 y range");
}

TEST(DrawingErrors, SayWhichOptionHasNoMeaning) {
    EXPECT_EQ(complaint([](Drawing& d) { d.width = 10; }), "drawing.option width");
    EXPECT_EQ(complaint([](Drawing& d) { d.columns = 0; }), "drawing.option columns");
    EXPECT_EQ(complaint([](Drawing& d) { d.panels[0].x_range = Interval{1, 1}; }),
              "drawing.option panel 0 x range");
    EXPECT_EQ(complaint([](Drawing& d) { d.panels[0].y_scale = AxisScale::log10; }),
              "drawing.option panel 0");
    EXPECT_EQ(complaint([](Drawing& d) {
                  PointsLayer layer{points({0, 0}), ""};
                  layer.corners = {1};
                  d.add(layer);
              }),
              "drawing.option panel 0 layer 1 corners");
    EXPECT_EQ(complaint([](Drawing& d) {
                  CombLayer layer{near_circle(1), ""};
                  layer.share = 0;
                  d.add(layer);
              }),
              "drawing.option panel 0 layer 1 share");
    EXPECT_EQ(complaint([](Drawing& d) {
                  CombLayer layer{near_circle(1), ""};
                  layer.scale = nan;
                  d.add(layer);
              }),
              "drawing.option panel 0 layer 1 scale");
    EXPECT_EQ(complaint([](Drawing& d) { d.add(TicksLayer{near_circle(1), {5}, ""}); }),
              "drawing.option panel 0 layer 1 ticks");
    EXPECT_EQ(complaint([](Drawing& d) {
                  d.add(ArrowsLayer{points({0, 0}), points({1, 1, 2, 2}), ""});
              }),
              "drawing.option panel 0 layer 1 directions");
    EXPECT_EQ(complaint([](Drawing& d) {
                  d.add(ControlPolygonLayer{exact_circle(1), ""});
              }),
              "drawing.no-control-points panel 0 layer 1");
    EXPECT_EQ(complaint([](Drawing& d) {
                  d.panels[0].layers = {CurveLayer{helix(), "", {}}};
                  d.panels[0].x_range = Interval{0, 1};
              }),
              "drawing.option panel 0");
}

TEST(SvgText, IsValidWhateverTheBytes) {
    drawing::Scene scene{100, 50, "a < b & \"c\"", "", {}};
    scene.add(drawing::TextShape{{1, 2}, "\x01\xff\xc3\xa9\xed\xa0\x80>", 10});
    const std::string text = drawing::svg(scene);
    EXPECT_NE(text.find("<title>a &lt; b &amp; &quot;c&quot;</title>"), std::string::npos);
    // A control character becomes a blank, each byte that is no UTF-8 the replacement character.
    EXPECT_NE(text.find("> \xEF\xBF\xBD\xc3\xa9\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD&gt;</text>"),
              std::string::npos);
}

}  // namespace drawing_errors_test
}  // namespace batten::testing
