#include <gtest/gtest.h>

#include <string>

#include "batten/base/error.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "errors.hpp"

namespace batten {
namespace curve_readers_test {

using testing::complaint_of;

std::string curve(const std::string& text) {
    return complaint_of([&] { parse_curve({"c", text}); });
}
/// A piecewise cubic of these entries.
std::string cubic(const std::string& entries) {
    return curve("{\"format\": \"batten.curve/1\", \"kind\": \"piecewise-cubic\", " + entries + "}");
}
std::string spline(const std::string& entries) {
    return curve("{\"format\": \"batten.curve/1\", \"kind\": \"b-spline\", " + entries + "}");
}
std::string arcs(const std::string& entries) {
    return curve("{\"format\": \"batten.curve/1\", \"kind\": \"arcs\", " + entries + "}");
}
std::string path(const std::string& data) {
    return complaint_of([&] { parse_svg_path(data, "c"); });
}

const std::string breaks = "\"breaks\": [0, 1], ";
const std::string points = "\"points\": [[0, 0], [1, 1]], ";
const std::string powers = "\"coefficients\": [[[1, 1], [0, 0], [0, 0]]]";

TEST(BadCurveFile, OfAnotherFormatOrKindIsRefused) {
    const std::string rule = ": a curve is a map with \"format\": \"batten.curve/1\", an SVG picture "
                             "or SVG path data";
    EXPECT_EQ(cubic(breaks + points + powers), "none");
    EXPECT_EQ(curve("{}"), "curve.format: c, entry format: missing" + rule);
    EXPECT_EQ(curve("{\"format\": \"batten.curve/2\"}"),
              "curve.format: c, entry format: batten.curve/2" + rule);
    EXPECT_EQ(curve("0,1\n"), "curve.format: c: '0'" + rule);
    EXPECT_EQ(complaint_of([] { curve_of(ValueList{1, 2}, "c"); }),
              "curve.format: c: a list of 2" + rule);
    EXPECT_EQ(curve(" \n"), "file.empty: c: no curve: the file must hold a curve");
    EXPECT_EQ(curve("{\"format\": \"batten.curve/1\", \"kind\": \"circle\"}"),
              "curve.kind: c, entry kind: circle: piecewise-cubic, b-spline, b-spline-graph, arcs or "
              "log-aesthetic is needed here");
    EXPECT_EQ(curve("{\"format\": \"batten.curve/1\"}").substr(0, 31),
              "curve.kind: c, entry kind: miss");
}

TEST(BadCurveFile, OfArcsThatAreNoneIsRefused) {
    EXPECT_EQ(arcs(points + "\"bulges\": [0.5]"), "none");
    EXPECT_EQ(arcs(points + "\"bulges\": [0.5, 1]"),
              "curve.entry: c, entry bulges: a list of 2: 1 entries are needed here");
    EXPECT_EQ(arcs(points + "\"closed\": false"),
              "curve.entry: c, entry bulges: missing: a list is needed here");
    EXPECT_EQ(arcs(points + "\"bulges\": [1e-320]").substr(0, 13), "curve.arcs: c");
    EXPECT_EQ(arcs(points + "\"closed\": true, \"bulges\": [1]").substr(0, 13), "curve.arcs: c");
    EXPECT_EQ(arcs("\"points\": [[0, 0], [0, 0]], \"bulges\": [1]").substr(0, 19),
              "points.all-equal: c");
    EXPECT_EQ(arcs("\"points\": [[0, 0], [0, 0], [1, 0]], \"bulges\": [1, 1]").substr(0, 18),
              "points.repeated: c");
    EXPECT_EQ(arcs("\"points\": [[0, 0, 0], [1, 0, 0]], \"bulges\": [1]").substr(0, 19),
              "points.dimension: c");
}

TEST(BadCurveFile, WithAWrongEntryIsRefused) {
    EXPECT_EQ(cubic(points + powers), "curve.entry: c, entry breaks: missing: a list is needed here");
    EXPECT_EQ(cubic(breaks + powers), "curve.entry: c, entry points: missing: a list is needed here");
    EXPECT_EQ(cubic(breaks + "\"points\": []"),
              "curve.entry: c, entry points: a list of 0: a list of points [x, y, ...] is needed "
              "here");
    EXPECT_EQ(cubic("\"breaks\": [0, \"1\"], " + points + powers),
              "curve.entry: c, entry breaks[1]: 1: a number is needed here");
    EXPECT_EQ(cubic("\"breaks\": [0, 1, 2], " + points + powers),
              "curve.entry: c, entry breaks: a list of 3: 2 entries are needed here");
    EXPECT_EQ(cubic(breaks + "\"points\": [[0, 0], [1]], " + powers),
              "curve.entry: c, entry points[1]: a list of 1: a list of 2 numbers is needed here");
    EXPECT_EQ(cubic(breaks + "\"points\": [[0, 0], [1, null]], " + powers),
              "curve.entry: c, entry points[1]: null: a number is needed here");
    EXPECT_EQ(cubic(breaks + points + "\"coefficients\": [[[1, 1], [0, 0]]]"),
              "curve.entry: c, entry coefficients[0]: a list of 2: a list of 3 lists is needed here");
    EXPECT_EQ(cubic("\"dimension\": 3, " + breaks + points + powers),
              "curve.entry: c, entry points[0]: a list of 2: a list of 3 numbers is needed here");
    EXPECT_EQ(cubic("\"closed\": 1, " + breaks + points + powers),
              "curve.entry: c, entry closed: 1: true or false is needed here");
    EXPECT_EQ(cubic("\"dimension\": 1.5, " + breaks + points + powers),
              "curve.entry: c, entry dimension: 1.5: a whole number is needed here");
}

TEST(BadCurveFile, OfACurveThatCannotBeIsRefused) {
    EXPECT_EQ(cubic("\"breaks\": [1, 0], " + points + powers),
              "curve.breaks: c, break 1: 0: breaks must be finite and strictly increasing");
    EXPECT_EQ(cubic("\"breaks\": [0], \"points\": [[0, 0]], \"coefficients\": []").substr(0, 12),
              "curve.breaks");
    EXPECT_EQ(cubic(breaks + "\"points\": [[0, 0], [1, 2]], " + powers),
              "curve.gap: c, entry coefficients[0]: a gap of 1: a piece must end at the next point");
    EXPECT_EQ(cubic("\"closed\": true, " + breaks + points + powers),
              "curve.gap: c, entry points: other ends: a closed curve must end where it starts");
    EXPECT_EQ(cubic("\"breaks\": [0, 1e200], " + points + "\"coefficients\": [[[1, 1], [0, 0], [1, 0]]]"),
              "number.overflow: c, entry coefficients[0]: beyond a double: the curve must lie "
              "within the range of a double");
    EXPECT_EQ(spline("\"degree\": 2, \"knots\": [0, 0, 1, 1], \"control_points\": [[0, 0], [1, 1]]")
                  .substr(0, 13),
              "bspline.knots");
    EXPECT_EQ(spline("\"degree\": 0, \"knots\": [0, 1], \"control_points\": [[0, 0]]").substr(0, 14),
              "bspline.degree");
    EXPECT_EQ(spline("\"degree\": 1, \"knots\": [0, 0, 1, 1], \"control_points\": [[0, 0]]")
                  .substr(0, 22),
              "bspline.control-points");
    EXPECT_EQ(spline("\"degree\": 1, \"knots\": [0, 0, 1, 1], \"control_points\": [[0, 0], [1, 1]], "
                     "\"weights\": [1, -1]")
                  .substr(0, 15),
              "bspline.weights");
    EXPECT_EQ(spline("\"degree\": 1, \"knots\": [0, 0, 1, 1], \"control_points\": [[0, 0], [1, 1]], "
                     "\"weights\": [1]"),
              "curve.entry: c, entry weights: a list of 1: 2 entries are needed here");
    EXPECT_EQ(spline("\"knots\": [0, 0, 1, 1], \"control_points\": [[0, 0], [1, 1]]"),
              "curve.entry: c, entry degree: missing: a whole number is needed here");
    EXPECT_EQ(spline("\"degree\": 3, \"closed\": true, \"knots\": [0, 1, 1], \"control_points\": "
                     "[[0, 0], [1, 1]]")
                  .substr(0, 13),
              "bspline.knots");
}

TEST(BadSvgPath, IsPlacedByItsFirstBadCharacter) {
    const struct {
        const char* data;
        const char* complaint;
    } cases[] = {
        {"", "svg.path: c path character 1: end of data: path data start with M or m"},
        {"L1 1", "svg.path: c path character 1: 'L': path data start with M or m"},
        {"M1", "svg.path: c path character 3: end of data: a number is needed here"},
        {"M1 1", "svg.path: c path character 5: end of data: a segment is needed here"},
        {"M1 1Z", "svg.path: c path character 6: end of data: a segment is needed here"},
        {"M0 0L1 x", "svg.path: c path character 8: 'x': a number is needed here"},
        {"M0 0L1 1 2", "svg.path: c path character 11: end of data: a number is needed here"},
        {"M0 0L1,,1", "svg.path: c path character 8: ',': a number is needed after a comma"},
        {"M0 0L1 1,", "svg.path: c path character 10: end of data: a number is needed after a "
                      "comma"},
        {"M0 0L1 1 B", "svg.path: c path character 10: 'B': a command letter or a number is needed "
                       "here"},
        {"M0 0L1 0 1 1Z 5 5", "svg.path: c path character 15: '5': a command letter is needed here"},
        {"M0 0A1 1 0 2 0 1 1", "svg.path: c path character 12: '2': a flag, 0 or 1, is needed here"},
        {"M0 0L--1 1", "svg.path: c path character 7: '-': a number is needed here"},
        {"M0 0L1 nan", "svg.path: c path character 8: 'n': a number is needed here"},
        {"M0 0L1 1\x07", "svg.path: c path character 9: byte 0x07: a command letter or a number is "
                         "needed here"},
        {"M0 0L1 1M2 2L3 3", "svg.subpaths: c path character 9: 'M': one curve is one path without "
                             "a second part"},
        {"M0 0L1 0 1 1ZL3 3", "svg.subpaths: c path character 14: 'L': one curve is one path "
                              "without a second part"},
        {"M0 0L1e999 1", "number.overflow: c path character 6: 1e999: numbers must lie within the "
                         "range of a double"},
        {"M1e308 0l1e308 0", "number.overflow: c path character 9: beyond a double: numbers must "
                             "lie within the range of a double"},
    };
    for (const auto& c : cases) EXPECT_EQ(path(c.data), c.complaint) << c.data;
}

TEST(BadSvgPicture, WithoutAPathIsRefused) {
    for (const char* text : {"<svg/>", "<svg><path/></svg>", "<path>", "<!-- <path d='M0 0L1 1'/>",
                             "<path d='M0 0L1 1", "<path d=", "<", "<path data='M0 0L1 1'/>"}) {
        EXPECT_EQ(curve(text), "svg.no-path: c: no path: the picture must hold a path element with "
                               "data d")
            << text;
    }
}

TEST(InexactCurve, IsNotWritten) {
    const Curve circle = CallableCurve{[](double, int, std::span<double> out) {
                                           for (double& x : out) x = 0;
                                       },
                                       2, {0, 1}, true};
    EXPECT_EQ(complaint_of([&] { curve_value(circle); }),
              "curve.not-exact: curve: no polynomial: this curve has no exact file form: convert "
              "it to cubic pieces first");
    EXPECT_EQ(complaint_of([&] { svg_path(circle); }),
              "curve.not-exact: curve: no polynomial: SVG path data take lines and cubics: convert "
              "the curve to cubic pieces first");
    const Curve quartic = BSplineCurve(BSplineBasis({0, 0, 0, 0, 0, 1, 1, 1, 1, 1}, 4), Points(5, 2));
    EXPECT_EQ(complaint_of([&] { svg_path(quartic); }).substr(0, 33), "curve.not-exact: curve: degree 4:");
    const Curve space = BSplineCurve(BSplineBasis({0, 0, 1, 1}, 1), Points(2, 3));
    EXPECT_EQ(complaint_of([&] { svg_picture(space); }),
              "curve.dimension: curve: 3 coordinates: SVG path data take two coordinates");
}

}  // namespace curve_readers_test
}  // namespace batten
