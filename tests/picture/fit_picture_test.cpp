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

/// Exact data with an error far too large: residuals all near 0.
Drawing drawn_calmly(const std::vector<Setting>& more) {
    std::string text = "x,y,sigma\n";
    for (int i = 0; i <= 40; ++i) {
        text += format_number(i / 40.0) + "," + format_fixed(std::sin(0.1 * i), 9) + ",0.001\n";
    }
    std::vector<Setting> settings{{"x", "x"}, {"y", "y"}};
    settings.insert(settings.end(), more.begin(), more.end());
    const Input input{"calm.csv", PointsInput{parse_table({"calm.csv", text}), {}}};
    return find_operation("fit")->run({&input, 1}, settings, {}).draw();
}

std::vector<std::string> names_in(const Panel& panel) {
    std::vector<std::string> names;
    for (const Layer& layer : panel.layers) {
        std::visit([&](const auto& any) {
            if constexpr (requires { any.name; }) names.push_back(any.name);
        }, layer);
    }
    return names;
}

TEST(Picture, OfAFitShowsTheBandOfOneSigmaAsAPartOfThePanel) {
    const Panel residuals = drawn_calmly({}).panels[1];
    ASSERT_TRUE(residuals.y_range);
    EXPECT_LE(residuals.y_range->lo, -2);
    EXPECT_GE(residuals.y_range->hi, 2);
}

TEST(Picture, OfAFitNamesNoErrorBarsThatHideBehindTheirDots) {
    for (const std::string& name : names_in(drawn_calmly({}).panels[0])) {
        EXPECT_EQ(name.find("errors"), std::string::npos);
    }
    EXPECT_EQ(names_in(drawn({}).panels[0]).front(), "errors ±σ");
}

TEST(Picture, OfAFitSaysNoProbabilityThatItDoesNotHave) {
    EXPECT_NE(drawn_calmly({}).subtitle.find("p > 0.999"), std::string::npos);
}

TEST(Picture, OfTheCriterionShowsHalfOfTheStepsAndTheOneChosen) {
    for (const char* const stop : {"bic", "aic"}) {
        const Drawing drawing = drawn({{"stop", stop}});
        const Panel& criterion = drawing.panels[2];
        ASSERT_TRUE(criterion.x_range);
        EXPECT_GE(criterion.x_range->length(), 6) << "whole numbers along the axis";
        std::size_t shown = 0, steps = 0;
        for (const Layer& layer : criterion.layers) {
            const auto* dots = std::get_if<PointsLayer>(&layer);
            if (!dots) continue;
            const bool is_chosen = dots->name == "chosen";
            for (std::size_t i = 0; i < dots->points.size(); ++i) {
                const bool is_in = !criterion.y_range ||
                                   criterion.y_range->contains(dots->points(i, 1));
                EXPECT_TRUE(is_in || !is_chosen);
                steps += is_chosen ? 0 : 1;
                shown += is_chosen ? 0 : is_in;
            }
        }
        EXPECT_GE(2 * shown, steps);
    }
    EXPECT_NE(drawn({{"knots", "pruned"}}).panels[2].caption.find("before knots are pruned"),
              std::string::npos);
}

TEST(Gnuplot, KeepsTheLegendAwayFromTheNamesOfTheAxes) {
    const std::string script = gnuplot_script(drawn({}), ChartFormat::png);
    EXPECT_NE(script.find("set key tmargin"), std::string::npos);
}

}  // namespace fit_picture_test
}  // namespace batten::testing
