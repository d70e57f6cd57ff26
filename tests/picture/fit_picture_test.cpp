#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "batten/api/operation.hpp"
#include "batten/base/text.hpp"
#include "pictures.hpp"
#include "shared.hpp"

// Pictures of fits, and of filled regions.
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

const PointsLayer* dots_named(const Panel& panel, const std::string& name) {
    for (const Layer& layer : panel.layers) {
        const auto* dots = std::get_if<PointsLayer>(&layer);
        if (dots && dots->name == name) return dots;
    }
    return nullptr;
}

TEST(Picture, OfAFitTellsSamplesWithoutWeightFromTheStepChosen) {
    const Drawing drawing = drawn({{"robust", "reject"}});
    const PointsLayer* left = dots_named(drawing.panels[0], "no weight");
    const PointsLayer* chosen = dots_named(drawing.panels[2], "chosen");
    ASSERT_TRUE(left && chosen);
    EXPECT_NE(left->tone, chosen->tone);
    EXPECT_GE(drawing.panels[2].x_range->lo, 0);
}

TEST(Picture, OfAFitShowsSamplesOverTheLineAndWhereToMeasureNext) {
    const Panel panel = drawn({{"suggest", "3"}}).panels[0];
    std::size_t line = 0, data = 0, suggested = 0;
    for (std::size_t k = 0; k < panel.layers.size(); ++k) {
        if (const auto* lines = std::get_if<PolylineLayer>(&panel.layers[k])) {
            if (lines->name == "fit") line = k;
            if (lines->name == "suggested") suggested = lines->runs.size();
        }
        const auto* dots = std::get_if<PointsLayer>(&panel.layers[k]);
        if (dots && dots->name == "data") data = k;
    }
    EXPECT_GT(data, line);
    EXPECT_EQ(suggested, 3u);
}

TEST(Picture, OfAParametricFitNamesItsAxesAndShowsResiduals) {
    std::string text = "east,north\n";
    for (int i = 0; i <= 80; ++i) {
        const double t = 0.05 * i, r = 1 + (i % 2 == 0 ? 0.01 : -0.01);
        text += format_fixed(r * std::cos(t), 6) + "," + format_fixed(r * std::sin(t), 6) + "\n";
    }
    const Input input{"arc.csv", PointsInput{parse_table({"arc.csv", text}), {}}};
    const Drawing drawing = find_operation("fit")
                                ->run({&input, 1}, {{"parametric", "true"}, {"sigma", "0.01"}}, {})
                                .draw();
    EXPECT_EQ(drawing.panels[0].x_label, "east");
    EXPECT_EQ(drawing.panels[0].y_label, "north");
    const PointsLayer* residuals = dots_named(drawing.panels[1], "data");
    ASSERT_TRUE(residuals);
    ASSERT_EQ(residuals->points.size(), 81u);
    // Every other point lies on the left of an arc that turns left: inside.
    for (std::size_t i = 10; i < 70; ++i) {
        EXPECT_NEAR(residuals->points(i, 1), i % 2 == 0 ? -1 : 1, 0.3) << i;
    }
}

TEST(Picture, OfAFitKeepsThePowerOfTenWhereNamesAreCut) {
    const std::string name = "photocurrent of the detector behind the second window of the chamber";
    Drawing drawing;
    Panel& panel = drawing.panels.front();
    panel.kind = PanelKind::chart;
    panel.y_label = name + " and " + name;
    panel.add(PolylineLayer{{Points({0, 1e-12, 1, 3e-12}, 2)}});
    EXPECT_NE(svg(drawing).find("… (×10⁻¹²)"), std::string::npos);
}

TEST(Region, IsFilledPalelyAndNamedInTheLegend) {
    Drawing drawing;
    drawing.add(RegionsLayer{{Points({0, 0, 4, 0, 4, 3}, 2), Points({5, 0, 6, 0, 6, 1}, 2)}, "part"});
    const std::string text = svg(drawing);
    EXPECT_NE(text.find("opacity=\"0.2\""), std::string::npos);
    EXPECT_NE(text.find(">part<"), std::string::npos);
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

/// A sine with few samples and large errors: the band of its slope is ten times as wide as the
/// slope where alternatives with many knots are barely determined.
constexpr const char* noisy_sine = R"(time,level,sigma
0.55,0.75,0.55
0.92,0.68,0.41
1.05,0.51,0.51
1.07,1.19,0.35
1.50,0.95,0.45
1.87,0.75,0.27
1.88,0.90,0.36
2.02,0.71,0.21
2.62,0.53,0.15
2.75,0.52,0.12
2.98,-0.22,0.45
3.18,0.43,0.33
3.46,-0.68,0.55
3.92,-0.62,0.52
4.07,-1.04,0.29
4.23,-1.02,0.59
4.33,-0.91,0.40
4.38,-1.16,0.48
4.71,-1.21,0.30
5.11,-1.06,0.20
5.17,-1.05,0.19
5.62,-0.91,0.19
5.93,-0.45,0.40
6.00,-0.22,0.16
6.33,0.15,0.11
6.44,0.49,0.52
6.57,0.65,0.15
6.69,0.50,0.33
6.80,0.34,0.34
6.83,1.29,0.41
6.94,0.24,0.35
7.29,1.39,0.57
7.76,0.54,0.48
8.14,1.10,0.39
8.49,-0.00,0.41
8.62,1.04,0.35
8.84,0.46,0.58
8.91,0.28,0.21
9.24,0.93,0.44
9.67,0.04,0.38)";

Drawing drawn_noisily() {
    const Input input{"noisy.csv", PointsInput{parse_table({"noisy.csv", noisy_sine}), {}}};
    return find_operation("fit")->run({&input, 1}, {{"x", "time"}, {"y", "level"}}, {}).draw();
}

const PolylineLayer* knots_of(const Panel& panel) {
    for (const Layer& layer : panel.layers) {
        const auto* lines = std::get_if<PolylineLayer>(&layer);
        if (lines && lines->name == "knots") return lines;
    }
    return nullptr;
}

TEST(Picture, OfAFitMarksKnotsAlikeInEveryPanelBelowWhatItShows) {
    const Drawing noisy = drawn_noisily(), other = drawn({});
    for (const Drawing& drawing : {noisy, other}) {
        for (const Panel& panel : drawing.panels) {
            const PolylineLayer* knots = knots_of(panel);
            if (!knots) continue;
            ASSERT_TRUE(panel.y_range);
            const Points& mark = knots->runs.front();
            EXPECT_GT(mark(0, 1), panel.y_range->lo) << panel.caption;
            const double share = (mark(1, 1) - mark(0, 1)) / panel.y_range->length();
            EXPECT_NEAR(share, 0.034, 0.002) << panel.caption;
            for (const Layer& layer : panel.layers) {
                const auto* dots = std::get_if<PointsLayer>(&layer);
                for (std::size_t i = 0; dots && i < dots->points.size(); ++i) {
                    EXPECT_GT(dots->points(i, 1), mark(1, 1)) << panel.caption;
                    EXPECT_LT(dots->points(i, 1), panel.y_range->hi) << panel.caption;
                }
            }
        }
    }
}

TEST(Picture, OfAFitScalesTheDerivativeByItselfAndCutsItsBand) {
    const Panel slopes = drawn_noisily().panels.back();
    Interval line{0, 0}, band{0, 0};
    const auto add = [](Interval& extent, const Points& points) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            extent = {std::min(extent.lo, points(i, 1)), std::max(extent.hi, points(i, 1))};
        }
    };
    for (const Layer& layer : slopes.layers) {
        const auto* lines = std::get_if<PolylineLayer>(&layer);
        if (lines && lines->name == "fit") add(line, lines->runs.front());
        if (const auto* region = std::get_if<RegionsLayer>(&layer)) add(band, region->outlines[0]);
    }
    ASSERT_TRUE(slopes.y_range);
    EXPECT_TRUE(slopes.y_range->contains(line.lo) && slopes.y_range->contains(line.hi));
    EXPECT_LT(slopes.y_range->length(), 2 * line.length());
    EXPECT_GT(band.length(), 3 * slopes.y_range->length()) << "nothing was there to be cut";
}

TEST(Picture, OfAFitShowsADoubleKnotAsTwoMarks) {
    const std::vector<double> knots{0.3, 0.5, 0.5, 0.7};
    const Drawing drawing = drawn({{"knots", knots}});
    const PolylineLayer* marks = knots_of(drawing.panels[0]);
    ASSERT_NE(marks, nullptr);
    ASSERT_EQ(marks->runs.size(), 6u);
    EXPECT_LT(marks->runs[2](0, 0), 0.5);
    EXPECT_GT(marks->runs[3](0, 0), 0.5);
    EXPECT_NEAR(marks->runs[3](0, 0) - marks->runs[2](0, 0), 0.01, 0.005);
}

}  // namespace fit_picture_test
}  // namespace batten::testing
