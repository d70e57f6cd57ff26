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

/// sin x / 10 over 0 to 300 as the graph of a spline of `degree`, with what a fit knows of it.
Outcome fitted_graph(const std::string& degree) {
    std::string text = "x,y,sigma\n";
    for (int i = 0; i <= 60; ++i) {
        text += format_number(5 * i) + "," + format_fixed(0.1 * std::sin(0.05 * i), 9) + ",0.001\n";
    }
    const Input input{"graph.csv", PointsInput{parse_table({"graph.csv", text}), {}}};
    return find_operation("fit")->run({&input, 1}, {{"degree", degree}}, {});
}

Drawing picture_of_graph(std::string_view operation, const std::vector<Setting>& settings) {
    const Input graph{"graph.json", std::get<Curve>(fitted_graph("3").output)};
    return find_operation(operation)->run({&graph, 1}, settings, {}).draw();
}

TEST(PictureOfAGraph, HasAnAxisOfItsOwnForEachCoordinate) {
    const Points beside({0, 0, 150, 0.1}, 2);
    for (const Drawing& drawing :
         {picture_of_graph("draw", {}), picture_of_graph("evaluate", {}),
          picture_of_graph("measure", {}), picture_of_graph("compare", {{"to", beside}})}) {
        const Panel& panel = drawing.panels.front();
        EXPECT_EQ(panel.kind, PanelKind::chart);
        EXPECT_EQ(panel.x_label + panel.y_label, "xy");
        EXPECT_NO_THROW(svg(drawing));
    }
    EXPECT_EQ(picture_of_graph("draw", {{"comb", "true"}}).panels.front().kind,
              PanelKind::geometry);
}

TEST(PictureOfAGraph, NamesItsAxesAsTheTableBesideIt) {
    const Table table = parse_table({"t.csv", "nm,counts\n0,0\n300,0.1\n"});
    const std::vector<Input> inputs{
        {"graph.json", std::get<Curve>(fitted_graph("3").output)},
        {"t.csv", PointsInput{table, coordinate_columns(table)}}};
    const Drawing drawing = find_operation("draw")->run(inputs, {}, {}).draw();
    EXPECT_EQ(drawing.panels.front().kind, PanelKind::chart);
    EXPECT_EQ(drawing.panels.front().x_label, "nm");
    EXPECT_EQ(drawing.panels.front().y_label, "counts");
}

TEST(PictureOfEvaluate, ShowsTheBandAndThePanelsOfDerivatives) {
    const Drawing drawing = picture_of_graph("evaluate", {{"derivatives", "2"}, {"band", "90"}});
    ASSERT_EQ(drawing.panels.size(), 3u);
    for (const Panel& panel : drawing.panels) {
        EXPECT_TRUE(std::holds_alternative<RegionsLayer>(panel.layers.front())) << panel.caption;
    }
    EXPECT_EQ(drawing.panels[2].y_label, "d²y/dx²");
    // A line has no third derivative worth a panel.
    EXPECT_EQ(picture_of_graph("evaluate", {{"derivatives", "9"}}).panels.size(), 4u);
}

}  // namespace operations_test
}  // namespace batten::testing
