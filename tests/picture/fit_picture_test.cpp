#include <gtest/gtest.h>

#include <cmath>

#include "batten/api/operation.hpp"
#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/draw/gnuplot.hpp"
#include "errors.hpp"
#include "pictures.hpp"
#include "shared.hpp"

// Pictures of fits, and of filled regions, and what gnuplot is told.
namespace batten::testing {
namespace fit_picture_test {

/// A bell on a slope, with one outlier.
std::string bell_table() {
    std::string text = "time,level,sigma\n";
    for (int i = 0; i <= 60; ++i) {
        const double x = i / 60.0, e = 12 * (x - 0.4);
        const double wobble = 0.05 * std::sin(40.0 * i * i);
        const double y = x + 2 * std::exp(-0.5 * e * e) + wobble + (i == 45 ? 1 : 0);
        text += format_number(x) + "," + format_fixed(y, 4) + ",0.04\n";
    }
    return text;
}

Drawing drawn(const std::vector<Setting>& more) {
    std::vector<Setting> settings{{"x", "time"}, {"y", "level"}};
    settings.insert(settings.end(), more.begin(), more.end());
    const Input input{"bell.csv", PointsInput{parse_table({"bell.csv", bell_table()}), {}}};
    return find_operation("fit")->run({&input, 1}, settings, {}).draw();
}

TEST(Picture, OfAFitShowsDataBandKnotsResidualsCriterionAndDerivative) {
    EXPECT_TRUE(is_golden("fit.svg", svg(drawn({{"robust", "reject"}}))));
}

TEST(Picture, OfAFitHasNoCriterionWhereKnotsAreGiven) {
    EXPECT_EQ(drawn({{"knots", std::vector<double>{0.3, 0.5}}}).panels.size(), 3u);
    EXPECT_EQ(drawn({{"knots", "equal"}, {"degree", "0"}}).panels.size(), 3u);
}

TEST(Region, IsFilledPalelyAndNamedInTheLegend) {
    Drawing drawing;
    drawing.add(RegionsLayer{{Points({0, 0, 4, 0, 4, 3}, 2), Points({5, 0, 6, 0, 6, 1}, 2)}, "part"});
    const std::string text = svg(drawing);
    EXPECT_NE(text.find("opacity=\"0.2\""), std::string::npos);
    EXPECT_NE(text.find(">part<"), std::string::npos);
}

TEST(Gnuplot, IsToldPanelsDataAndNames) {
    const std::string script = gnuplot_script(drawn({}), ChartFormat::png);
    EXPECT_EQ(script.find("set encoding utf8\nset terminal pngcairo"), 0u);
    EXPECT_NE(script.find("set multiplot layout 2,2"), std::string::npos);
    for (const char* const words : {"title \"data\"", "title \"fit\"", "title \"95 % band\"",
                                    "set ylabel \"level\"", "filledcurves", "END_OF_DATA"}) {
        EXPECT_NE(script.find(words), std::string::npos) << words;
    }
    EXPECT_EQ(gnuplot_script(drawn({}), ChartFormat::pdf).find("set encoding utf8\nset terminal pdf"),
              0u);
}

TEST(Gnuplot, GetsCaptionsThatCannotLeaveTheirQuotes) {
    Drawing drawing;
    drawing.title = "a\"; system \"x\\";
    drawing.add(PointsLayer{Points({0, 0, 1, 1}, 2), "`x` $y\nz"});
    const std::string script = gnuplot_script(drawing, ChartFormat::svg);
    EXPECT_NE(script.find("\"a\\\"; system \\\"x\\\\\""), std::string::npos);
    EXPECT_NE(script.find("\"\\`x\\` \\$y z\""), std::string::npos);
}

TEST(Gnuplot, IsNotAskedForWhatItCannotDraw) {
    const auto code = [](const Layer& layer) {
        Drawing drawing;
        drawing.add(layer);
        return code_of([&] { gnuplot_script(drawing, ChartFormat::png); });
    };
    EXPECT_EQ(code(CombLayer{near_circle(1)}), "drawing.gnuplot");
    EXPECT_EQ(code(ControlPolygonLayer{near_circle(1)}), "drawing.gnuplot");
    EXPECT_EQ(code(ArrowsLayer{Points({0, 0}, 2), Points({1, 1}, 2)}), "drawing.gnuplot");
    EXPECT_EQ(code(TextLayer{{0, 0, 1}, "text"}), "drawing.gnuplot");
    EXPECT_EQ(code(CurveLayer{helix()}), "none");
    EXPECT_EQ(code(CurveLayer{near_circle(1)}), "none");
    EXPECT_EQ(code(TicksLayer{near_circle(1), {0}}), "none");
}

}  // namespace fit_picture_test
}  // namespace batten::testing
