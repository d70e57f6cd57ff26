#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "batten/api/operation.hpp"
#include "batten/base/text.hpp"
#include "batten/io/table.hpp"
#include "batten/shape/log_aesthetic.hpp"
#include "shared.hpp"

// What `--draw` draws. After a change on purpose: BATTEN_GOLDEN=accept, and look.
namespace batten::testing {
namespace operations_test {

/// The picture of an operation on these points.
std::string picture_of(std::string_view operation, const Source& points,
                       const std::vector<Setting>& settings) {
    const Table table = parse_table(points);
    const Input input{points.name, PointsInput{table, coordinate_columns(table)}};
    return svg(find_operation(operation)->run({&input, 1}, settings, {}).draw());
}

Source violin() {
    return {"violin.csv", read_text(source_file("cases/points/violin.csv"))};
}

Source half_ellipse() {
    std::string text;
    for (int i = 0; i <= 6; ++i) {
        const double t = std::numbers::pi * i / 6;
        text += format_fixed(2 * std::cos(t), 6) + "," + format_fixed(std::sin(t), 6) + "\n";
    }
    return {"ellipse.csv", text};
}

TEST(PictureOfArcs, ShowsSidesJointsAndErrors) {
    EXPECT_TRUE(is_golden("arcs_chain.svg", picture_of("arcs", half_ellipse(),
                                                       {{"start_angle", "90"}})));
    EXPECT_TRUE(is_golden("arcs_violin.svg",
                          picture_of("arcs", violin(), {{"closed", "true"}, {"tolerance", "2"}})));
}

TEST(PictureOfDensify, ShowsGivenAndNewPoints) {
    EXPECT_TRUE(
        is_golden("densify.svg", picture_of("densify", half_ellipse(), {{"between", "3"}})));
}

TEST(PictureOfThin, ShowsWhatIsKept) {
    EXPECT_TRUE(is_golden("thin.svg", picture_of("thin", violin(),
                                                 {{"closed", "true"}, {"tolerance", "4"}})));
}

/// Points of an arch, every other one off by a little.
Source rough_arch() {
    std::string text;
    for (int i = 0; i <= 40; ++i) {
        const double t = 0.5 + 0.05 * i, r = 1 + (i % 2 == 0 ? 0.002 : -0.002);
        text += format_fixed(2 * r * std::cos(t), 6) + "," + format_fixed(r * std::sin(t), 6) + "\n";
    }
    return {"arch.csv", text};
}

TEST(PictureOfFair, ShowsPointsASmoothCurveAndBothCurvatures) {
    EXPECT_TRUE(is_golden("fair.svg", picture_of("fair", rough_arch(), {{"sigma", "0.002"}})));
}

TEST(PictureOfDraw, LeavesOutTheGraphOfACurveOfConstantCurvature) {
    const std::vector<double> start{0, 0};
    const Input arc{"arc.json", Curve(LogAestheticCurve(start, 0, {1, 1.5, 1, 1}))};
    const Outcome made =
        find_operation("draw")->run({&arc, 1}, {{"lcg", "true"}, {"comb", "true"}}, {});
    EXPECT_EQ(made.draw().panels.size(), 1u);
    EXPECT_NE(svg(made.draw()).find("<path"), std::string::npos);
}

}  // namespace operations_test
}  // namespace batten::testing
