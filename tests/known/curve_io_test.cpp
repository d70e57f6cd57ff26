#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "batten/io/curve_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/io/write_points.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "batten/shape/transform.hpp"

namespace batten {
namespace curve_io_test {

Curve path(const std::string& data) { return parse_svg_path(data, "test"); }

const PiecewiseCubic hill = PiecewiseCubic::hermite(
    Points({0, 0, 1, 1, 2, 0}, 2), Points({1, 1.5, 1, 0}, 2), Points({1, 0, 1, -1.5}, 2), {0, 1, 2},
    false);

TEST(CurveFile, IsPleasantToRead) {
    EXPECT_EQ(dump_json(curve_value(hill, "a hill")), R"({
  "format": "batten.curve/1",
  "kind": "piecewise-cubic",
  "name": "a hill",
  "dimension": 2,
  "closed": false,
  "breaks": [0, 1, 2],
  "points": [[0, 0], [1, 1], [2, 0]],
  "coefficients": [[[1, 1.5], [0, 0], [0, -0.5]], [[1, 0], [0, -1.5], [0, 0.5]]]
}
)");
}

TEST(CurveFile, IgnoresEntriesItDoesNotKnow) {
    Value tree = curve_value(hill);
    tree.map()->emplace_back("source", "a test");
    EXPECT_EQ(*curve_of(tree, "test").shape<PiecewiseCubic>(), hill);
}

TEST(CurveFile, MayLeaveOutDimensionAndClosed) {
    const Curve curve = curve_of(
        parse_json(R"({"format": "batten.curve/1", "kind": "b-spline", "degree": 1,
                       "knots": [0, 0, 1, 1], "control_points": [[0, 0, 0], [1, 2, 3]]})",
                   "test"),
        "test");
    EXPECT_EQ(curve(0.5), std::vector<double>({0.5, 1, 1.5}));
    EXPECT_FALSE(curve.is_closed());
}

TEST(SvgPath, OfACurveHasItsLinesAndCubics) {
    EXPECT_EQ(svg_path(hill),
              "M 0 0 C 0.3333333333333333 0.5 0.6666666666666667 1 1 1 "
              "C 1.3333333333333333 1 1.6666666666666667 0.5 2 0");
    EXPECT_EQ(svg_path(path("M0 0h2v1z")), "M 0 0 L 2 0 L 2 1 L 0 0 Z");
}

TEST(SvgPath, IsReadWithEveryCommandInBothCases) {
    EXPECT_EQ(svg_path(path("M1 2L3 4H5V6")), "M 1 2 L 3 4 L 5 4 L 5 6");
    EXPECT_EQ(svg_path(path("m1 2l2 2h2v2")), "M 1 2 L 3 4 L 5 4 L 5 6");
    EXPECT_EQ(svg_path(path("M1 2 3 4 5 6")), "M 1 2 L 3 4 L 5 6");
    EXPECT_EQ(svg_path(path("m1 2 2 2 2 2")), "M 1 2 L 3 4 L 5 6");
    EXPECT_EQ(svg_path(path("M0 0C0 3 3 3 3 0S6 -3 6 0")), "M 0 0 C 0 3 3 3 3 0 C 3 -3 6 -3 6 0");
    EXPECT_EQ(svg_path(path("m0 0c0 3 3 3 3 0s3-3 3 0")), "M 0 0 C 0 3 3 3 3 0 C 3 -3 6 -3 6 0");
    EXPECT_EQ(svg_path(path("M0 0S3 3 3 0")), "M 0 0 C 0 0 3 3 3 0");
    EXPECT_EQ(svg_path(path("M0 0Q3 3 6 0T12 0")), "M 0 0 C 2 2 4 2 6 0 C 8 -2 10 -2 12 0");
    EXPECT_EQ(svg_path(path("m0 0q3 3 6 0t6 0")), "M 0 0 C 2 2 4 2 6 0 C 8 -2 10 -2 12 0");
    EXPECT_EQ(svg_path(path("M0 0T12 0")), svg_path(path("M0 0Q0 0 12 0")));
    EXPECT_EQ(svg_path(path("M.5.5-1e-1-.25L1e2+3")), "M 0.5 0.5 L -0.1 -0.25 L 100 3");
    EXPECT_EQ(svg_path(path("M0,0 L1 , 1 Z")), "M 0 0 L 1 1 L 0 0 Z");
}

TEST(SvgPath, LeavesOutSegmentsOfNoLength) {
    EXPECT_EQ(svg_path(path("M0 0L0 0 1 0 1 0Z")), "M 0 0 L 1 0 L 0 0 Z");
    EXPECT_EQ(svg_path(path("M0 0L1 0L0 0Z")), "M 0 0 L 1 0 L 0 0 Z");
}

TEST(SvgPath, ReadsThreadsOfFlagsAsTheStandardWritesThem) {
    const std::string spaced = "M 0 0 A 1 1 0 1 0 1 1 A 1 1 0 0 1 2 0.5";
    const std::string tight = "M0 0A1 1 0 101 1 1 1 0 012 .5";
    const Curve a = path(spaced), b = path(tight);
    EXPECT_EQ(*a.shape<BSplineCurve>(), *b.shape<BSplineCurve>());
}

/// The greatest distance of |c(t) - center| from `radius` at 100 parameters.
double distance_from_circle(const Curve& curve, double x, double y, double radius) {
    double worst = 0;
    for (int i = 0; i <= 100; ++i) {
        const std::vector<double> p = curve(curve.domain().hi * (i / 100.0));
        worst = std::fmax(worst, std::fabs(std::hypot(p[0] - x, p[1] - y) - radius));
    }
    return worst;
}

TEST(SvgArc, LiesOnItsCircle) {
    // Both circles of radius 5 through (0, 0) and (6, 0), the short and the long way.
    EXPECT_LT(distance_from_circle(path("M0 0A5 5 0 0 0 6 0"), 3, -4, 5), 4e-15);
    EXPECT_LT(distance_from_circle(path("M0 0A5 5 0 0 1 6 0"), 3, 4, 5), 4e-15);
    EXPECT_LT(distance_from_circle(path("M0 0A5 5 0 1 0 6 0"), 3, 4, 5), 4e-15);
    EXPECT_LT(distance_from_circle(path("M0 0A5 5 0 1 1 6 0"), 3, -4, 5), 4e-15);
}

TEST(SvgArc, GoesTheWayItsFlagsTell) {
    // Sweep 1 turns from x to y: left where y is up.
    EXPECT_LT(path("M0 0A5 5 0 0 1 6 0")(0.5)[1], 0);
    EXPECT_GT(path("M0 0A5 5 0 0 0 6 0")(0.5)[1], 0);
    const Curve large = path("M0 0A5 5 0 1 1 6 0");
    EXPECT_NEAR(large(large.domain().middle())[1], -9, 1e-14);
}

TEST(SvgArc, IsASlantedEllipse) {
    // Half axes 2 and 1 turned by 90 degrees, from the top to the right end.
    const Curve curve = path("M0 2A2 1 90 0 0 1 0");
    for (int i = 0; i <= 20; ++i) {
        const std::vector<double> p = curve(curve.domain().hi * i / 20.0);
        EXPECT_NEAR(p[0] * p[0] + p[1] * p[1] / 4, 1, 4e-15);
    }
    EXPECT_EQ(curve(0), std::vector<double>({0, 2}));
    EXPECT_EQ(curve(curve.domain().hi), std::vector<double>({1, 0}));
}

TEST(SvgArc, WithRadiiTooSmallIsHalfAnEllipse) {
    EXPECT_LT(distance_from_circle(path("M0 0A1 1 0 0 1 6 0"), 3, 0, 3), 4e-15);
}

TEST(SvgArc, WithoutARadiusIsALine) {
    EXPECT_EQ(svg_path(path("M0 0A0 5 0 0 1 6 0")), "M 0 0 L 6 0");
}

TEST(SvgArc, ClosesWithZ) {
    const Curve circle = path("M1 0A1 1 0 0 1-1 0 1 1 0 0 1 1 0Z");
    EXPECT_TRUE(circle.is_closed());
    EXPECT_LT(distance_from_circle(circle, 0, 0, 1), 1e-15);
    EXPECT_EQ(circle.breaks().size(), 5u);
}

TEST(SvgPicture, GivesItsFirstPath) {
    const char* const picture =
        "<?xml version='1.0'?><!-- <path d='M9 9L8 8'/> --><svg><pathology d='M1 1L9 9'/>"
        "<path class=\"a>b\"/><path id='d' d='M0 0L2 1'/><path d='M3 3L4 4'/></svg>";
    EXPECT_EQ(svg_path(parse_curve({"a.svg", picture})), "M 0 0 L 2 1");
    EXPECT_EQ(first_svg_path("<svg:path d='M1 1'/><path\nd=\"M2 2\"/>", "test"), "M2 2");
}

TEST(SvgPicture, ShowsTheCurveUprightAndWhole) {
    EXPECT_EQ(svg_picture(path("M0 0L100 0L100 50")),
              "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-4 -54 108 58\">\n"
              "  <path transform=\"scale(1 -1)\" fill=\"none\" stroke=\"#1f2933\" "
              "stroke-width=\"0.4\"\n    d=\"M 0 0 L 100 0 L 100 50\"/>\n</svg>\n");
}

TEST(CurveSource, IsToldByItsContent) {
    EXPECT_TRUE(holds_curve({"c.json", " {}"}));
    EXPECT_FALSE(holds_curve({"p.json", "[[0, 1]]"}));
    EXPECT_TRUE(holds_curve({"a.svg", ""}));
    EXPECT_TRUE(holds_curve({"standard input", "M0 0L1 1"}));
    EXPECT_TRUE(holds_curve({"standard input", "<svg/>"}));
    EXPECT_FALSE(holds_curve({"standard input", "mass,y\n1,2\n"}));
    EXPECT_FALSE(holds_curve({"p.csv", "M1,2\n"}));
    EXPECT_FALSE(holds_curve({"standard input", "0,1\n"}));
}

TEST(CurveSamples, AreRowsOfParameterAndPoint) {
    const std::vector<double> t{0, 0.5, 2};
    EXPECT_EQ(csv_samples(hill, t), "t,x,y\n0,0,0\n0.5,0.5,0.6875\n2,2,0\n");
}

TEST(WrittenPoints, AreShortAndExact) {
    const Points points({0.1, 1e-7, -2, 1e22}, 2);
    EXPECT_EQ(csv_points(points, {"x", "y \"up\", m"}),
              "x,\"y \"\"up\"\", m\"\n0.1,1e-07\n-2,1e+22\n");
    EXPECT_EQ(json_points(points), "[\n  [0.1, 1e-07],\n  [-2, 1e+22]\n]\n");
    EXPECT_EQ(npy_points(points).size(), 128u + 32u);
}

}  // namespace curve_io_test
}  // namespace batten
