#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "batten/io/curve_file.hpp"
#include "batten/io/draw/gnuplot.hpp"
#include "batten/io/draw/surface_plots.hpp"
#include "pictures.hpp"

// What gnuplot is told: the picture that SVG shows.
namespace batten::testing {
namespace gnuplot_test {

std::size_t count_of(const std::string& words, const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
        ++count;
    }
    return count;
}

Drawing of(Layer layer) {
    Drawing drawing;
    drawing.add(std::move(layer));
    return drawing;
}

Heights saddle() {
    Heights heights{even_places({0, 4}, 9), even_places({0, 3}, 9), Grid(9, 9)};
    for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t j = 0; j < 9; ++j) {
            heights.z(i, j) = heights.x[i] * heights.x[i] - 2 * heights.y[j];
        }
    }
    return heights;
}

TEST(Gnuplot, WritesEveryTextOfThePicture) {
    for (const Drawing& drawing : {six_curves_picture(), curvature_picture(), helix_picture(),
                                   of(TextLayer{{0, 0, 1}, "text"})}) {
        const std::string script = gnuplot_script(drawing, ChartFormat::png);
        EXPECT_EQ(count_of("set label ", script), count_of("<text", svg(drawing)));
    }
}

TEST(Gnuplot, DrawsEveryKindOfLayer) {
    const std::vector<Layer> layers{CombLayer{near_circle(1)}, ControlPolygonLayer{near_circle(1)},
                                    ArrowsLayer{Points({0, 0}, 2), Points({1, 1}, 2)},
                                    CurveLayer{helix()}, TicksLayer{near_circle(1), {0}}};
    for (const Layer& layer : layers) {
        Drawing drawing = of(layer);
        drawing.panels[0].axes = AxesStyle::hidden;
        const std::string script = gnuplot_script(drawing, ChartFormat::svg);
        EXPECT_EQ(count_of("with lines", script) + count_of("with filledcurves", script) +
                      count_of("with circles", script),
                  count_of("stroke=", svg(drawing)) + count_of("fill=\"#", svg(drawing)) - 1)
            << "all but the paper";
    }
}

TEST(Gnuplot, NamesTheAxesOfReliefsAndDrawsTheLinesUponThem) {
    const auto drawn = [](const std::vector<double>& levels) {
        Drawing drawing;
        drawing.panels = {relief_plot(saddle(), {levels}, "relief")};
        return gnuplot_script(drawing, ChartFormat::png);
    };
    const std::string plain = drawn({}), lined = drawn({2.5});
    for (const char* const name : {"\"x\"", "\"y\"", "\"z\"", "\"relief\""}) {
        EXPECT_NE(plain.find(name), std::string::npos) << name;
    }
    EXPECT_GT(count_of("with lines", lined), count_of("with lines", plain) + 5);
}

/// The rows of the longest block of data.
std::vector<std::array<double, 2>> longest_block(const std::string& script) {
    std::vector<std::array<double, 2>> longest, block;
    std::istringstream lines(script);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream row(line);
        std::array<double, 2> p{};
        if (row >> p[0] >> p[1]) block.push_back(p);
        else block.clear();
        if (block.size() > longest.size()) longest = block;
    }
    return longest;
}

TEST(Gnuplot, DrawsALongCubicWithoutAKink) {
    Drawing drawing;
    drawing.add(CurveLayer{parse_curve({"arch.svg", "M 0 0 C 0 100 100 100 100 0"})});
    const auto rows = longest_block(gnuplot_script(drawing, ChartFormat::png));
    ASSERT_GT(rows.size(), 20u);
    double sharpest = 0;
    for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
        const double before = std::atan2(rows[i][1] - rows[i - 1][1], rows[i][0] - rows[i - 1][0]);
        const double after = std::atan2(rows[i + 1][1] - rows[i][1], rows[i + 1][0] - rows[i][0]);
        const double turn = std::remainder(after - before, 2 * std::numbers::pi);
        sharpest = std::max(sharpest, std::fabs(turn));
    }
    EXPECT_LT(sharpest, 0.12);
}

TEST(Gnuplot, CutsOffWhatLiesOutsideOfARange) {
    Drawing drawing = of(PolylineLayer{{Points({0, 0, 1, 1}, 2)}});
    const std::string whole = gnuplot_script(drawing, ChartFormat::pdf);
    drawing.panels[0].x_range = Interval{0.2, 0.8};
    const std::string cut = gnuplot_script(drawing, ChartFormat::pdf);
    EXPECT_EQ(count_of("set lmargin at screen 0\n", whole), count_of("set lmargin", whole));
    EXPECT_EQ(count_of("set lmargin at screen 0\n", cut) + 1, count_of("set lmargin", cut));
    EXPECT_EQ(cut.find("set encoding utf8\nset terminal pdfcairo"), 0u);
}

TEST(Gnuplot, GetsCaptionsThatCannotLeaveTheirQuotes) {
    Drawing drawing;
    drawing.title = "a\"; system \"x\\";
    drawing.add(PointsLayer{Points({0, 0, 1, 1}, 2), "`x` $y\nz"});
    const std::string script = gnuplot_script(drawing, ChartFormat::svg);
    EXPECT_NE(script.find("\"a\\\"; system \\\"x\\\\\""), std::string::npos);
    EXPECT_NE(script.find("\"\\`x\\` \\$y z\""), std::string::npos);
}

}  // namespace gnuplot_test
}  // namespace batten::testing
