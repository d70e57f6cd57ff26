#include <gtest/gtest.h>

#include <limits>

#include "batten/base/error.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/make/log_aesthetic.hpp"
#include "batten/shape/log_aesthetic_space.hpp"
#include "errors.hpp"

namespace batten {
namespace log_aesthetic_bad_test {

using testing::code_of;
using testing::nan;

std::string code_of_segment(std::vector<double> points, double alpha = 0.5) {
    return code_of([&] { log_aesthetic({points, alpha}); });
}

std::string code_of_arc(LogAestheticSegment arc) {
    return code_of([&] { LogAestheticCurve(std::vector<double>{0, 0}, 0, arc); });
}

TEST(LogAesthetic, RefusesPointsThatAreNoTriangle) {
    EXPECT_EQ(code_of_segment({}), "log-aesthetic.points");
    EXPECT_EQ(code_of_segment({0, 0, 1, 0}), "log-aesthetic.points");
    EXPECT_EQ(code_of_segment({0, 0, 1, nan, 2, 2}), "points.not-finite");
    EXPECT_EQ(code_of_segment({0, 0, 0, 0, 2, 2}), "points.repeated");
    EXPECT_EQ(code_of_segment({0, 0, 1, 1, 0, 0}), "points.repeated");
    EXPECT_EQ(code_of_segment({0, 0, 1, 0, 1, 1}, nan), "option.range");
    EXPECT_EQ(code_of_segment({0, 0, 1, 0, 1, 1}, 1e9), "option.range");
}

TEST(LogAesthetic, SaysWhenNoArcExists) {
    for (const std::vector<double>& points :
         {std::vector<double>{0, 0, 1, 0, 1, 20}, {0, 0, 1, 0, 0.5, 0}}) {
        const LogAestheticMade made = log_aesthetic({points, -1});
        EXPECT_FALSE(made.report.drawable);
        EXPECT_FALSE(made.curve);
        EXPECT_EQ(made.report.status, Status::not_met);
        ASSERT_EQ(made.report.notes.size(), 1u);
        EXPECT_NE(made.report.notes[0].find("no arc of alpha -1"), std::string::npos);
    }
}

TEST(LogAesthetic, MakesAStraightLineOfPointsInARow) {
    const LogAestheticMade made = log_aesthetic({{0, 0, 3, 4, 6, 8}, 2});
    EXPECT_TRUE(made.report.drawable);
    EXPECT_EQ(*made.report.length, 10);
    EXPECT_FALSE(made.report.lambda);
}

TEST(LogAestheticCurve, RefusesArcsThatAreNone) {
    EXPECT_EQ(code_of_arc({0.5, 1, 1, 2}), "none");
    EXPECT_EQ(code_of_arc({0.5, 0, 1, 2}), "log-aesthetic.pieces");
    EXPECT_EQ(code_of_arc({nan, 1, 1, 2}), "log-aesthetic.pieces");
    EXPECT_EQ(code_of_arc({0.5, 1, 1, -2}), "log-aesthetic.pieces");
    EXPECT_EQ(code_of_arc({0.5, 1, 0, 1}), "log-aesthetic.pieces");
    EXPECT_EQ(code_of_arc({-1, 1, 1, -2}), "none");
    EXPECT_EQ(code_of_arc({0.5, 1, 1e300, 1e-300}), "log-aesthetic.pieces");
    EXPECT_EQ(code_of_arc({-1, 1e9, 1, -1}), "log-aesthetic.pieces");
    EXPECT_EQ(code_of_arc({-1, 1e300, 1e300, 1}), "log-aesthetic.pieces");
    EXPECT_EQ(code_of([] { LogAestheticCurve(Points(2, 2), {0.0, 1.0}, {{}, {}}); }),
              "log-aesthetic.pieces");
}

std::string code_of_file(const std::string& entries) {
    return code_of([&] {
        parse_curve({"c.json", "{\"format\": \"batten.curve/1\", \"kind\": \"log-aesthetic\", " +
                                   entries + "}"});
    });
}

TEST(LogAestheticCurve, OfAFileMustFitItsPoints) {
    const std::string points = "\"points\": [[0, 0], [2, 0]], ", angles = "\"angles\": [0], ";
    EXPECT_EQ(code_of_file(points + angles + "\"arcs\": [[-1, 2, 0, 0]]"), "none");
    EXPECT_EQ(code_of_file(points + angles + "\"arcs\": [[-1, 2, 1, 0]]"), "curve.gap");
    EXPECT_EQ(code_of_file(points + angles + "\"arcs\": [[-1, 2, 0]]"), "curve.entry");
    EXPECT_EQ(code_of_file(points + angles + "\"arcs\": [[-1, -2, 0, 0]]"), "log-aesthetic.pieces");
    EXPECT_EQ(code_of_file(points + "\"arcs\": [[-1, 2, 0, 0]]"), "curve.entry");
    EXPECT_EQ(code_of_file(angles + "\"arcs\": [[-1, 2, 0, 0]]"), "curve.entry");
    EXPECT_EQ(code_of_file(points + "\"closed\": true, " + angles + "\"arcs\": [[-1, 2, 0, 0]]"),
              "curve.gap");
}

TEST(LogAestheticCurve, ReadsBackFromItsFileBitForBit) {
    const LogAestheticMade made = log_aesthetic({{0, 0, 1, 0.3, 1.3, 0.9}, 0.5});
    const Curve copy = curve_of(curve_value(*made.curve), "c");
    ASSERT_TRUE(copy.shape<LogAestheticCurve>());
    EXPECT_EQ(*copy.shape<LogAestheticCurve>(), *made.curve);
}

TEST(LogAestheticSpaceCurve, RefusesRadiiThatVanish) {
    const auto code = [](RadiusLaw curvature, double length) {
        return code_of([&] { LogAestheticSpaceCurve(curvature, {1, 0.5, 1}, length); });
    };
    EXPECT_EQ(code({1, 1, 1}, 2), "none");
    EXPECT_EQ(code({1, -1, 1}, 2), "log-aesthetic.pieces");
    EXPECT_EQ(code({1, 1, 1}, 0), "log-aesthetic.pieces");
    EXPECT_EQ(code({1, nan, 1}, 1), "log-aesthetic.pieces");
}

}  // namespace log_aesthetic_bad_test
}  // namespace batten
