#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "batten/base/error.hpp"
#include "batten/measure/area.hpp"
#include "batten/measure/centroid.hpp"
#include "batten/measure/compare.hpp"
#include "batten/measure/coordinate.hpp"
#include "batten/measure/length.hpp"
#include "batten/measure/line.hpp"
#include "batten/measure/measure.hpp"
#include "batten/measure/nearest.hpp"
#include "curves.hpp"
#include "errors.hpp"

namespace batten {
namespace measure_bad_test {

using namespace batten::testing;

const Curve plane = bezier({0, 0, 1, 2, 3, 3, 4, 0});
const Curve space = bezier({0, 0, 0, 1, 2, 0, 0, 1, 3, 2, 0, 1}, 3);

TEST(MeasuresRefuse, TolerancesThatAreNotPositive) {
    for (const double value : {0.0, -1.0, nan, inf}) {
        EXPECT_EQ(code_of([&] { length(plane, absolute(value)); }), "option.range");
        EXPECT_EQ(code_of([&] { centroid(plane, relative(value)); }), "option.range");
        EXPECT_EQ(code_of([&] { measure(plane, {relative(value)}); }), "option.range");
        EXPECT_EQ(code_of([&] { hausdorff(plane, plane, absolute(value)); }), "option.range");
        EXPECT_EQ(code_of([&] { compare(plane, {plane, absolute(value)}); }), "option.range");
    }
}

TEST(MeasuresRefuse, TheWrongDimension) {
    EXPECT_EQ(code_of([] { area(space); }), "curve.dimension");
    EXPECT_EQ(code_of([] { areas_by_winding(space); }), "curve.dimension");
    EXPECT_EQ(code_of([] { turning(space); }), "curve.dimension");
    EXPECT_EQ(code_of([] { inflections(space); }), "curve.dimension");
    EXPECT_EQ(code_of([] { line_intersections(space, {}); }), "curve.dimension");
    EXPECT_EQ(code_of([] { nearest(space, std::vector<double>{1, 2}); }), "points.dimension");
    EXPECT_EQ(code_of([] { hausdorff(plane, space); }), "curve.dimension");
    EXPECT_EQ(code_of([] { deviation(plane, Points({1, 2, 3}, 3)); }), "points.dimension");
}

TEST(MeasuresRefuse, PlacesOutsideTheCurve) {
    EXPECT_EQ(code_of([] { length(plane, Interval{0.5, 2}); }), "curve.outside");
    EXPECT_EQ(code_of([] { length(plane, Interval{0.7, 0.2}); }), "curve.part-empty");
    EXPECT_EQ(code_of([] { integral(plane, 0, {-1, 0}); }), "curve.outside");
    EXPECT_EQ(code_of([] { roots(plane, 2, 0); }), "curve.coordinate");
    EXPECT_EQ(code_of([] { extrema(plane, -1); }), "curve.coordinate");
}

TEST(MeasuresRefuse, PointsThatAreNone) {
    EXPECT_EQ(code_of([] { nearest(plane, std::vector<double>{nan, 0}); }), "points.not-finite");
    EXPECT_EQ(code_of([] { deviation(plane, Points(2)); }), "points.too-few");
    EXPECT_EQ(code_of([] { compare(plane, {}); }), "points.too-few");
    EXPECT_EQ(code_of([] { line_intersections(plane, {{0, 0}, {0, 0}}); }), "line.direction");
    EXPECT_EQ(code_of([] { line_intersections(plane, {{0, nan}, {1, 0}}); }),
              "points.not-finite");
}

TEST(MeasuresRefuse, FunctionsThatAreNotFinite) {
    const Curve broken = CallableCurve{[](double t, int order, std::span<double> out) {
                                           for (int k = 0; k <= order; ++k) {
                                               out[2 * k] = t > 0.3 ? std::sqrt(0.5 - t) : t;
                                               out[2 * k + 1] = t;
                                           }
                                       },
                                       2,
                                       {0, 1},
                                       false};
    EXPECT_EQ(code_of([&] { measure(broken); }), "curve.not-finite");
}

TEST(MeasuresRefuse, ResultsBeyondADouble) {
    const Curve huge = mapped(ellipse(1, 1), {1e308, 0, 0, 1e308, 0, 0});
    EXPECT_EQ(code_of([&] { length(huge); }), "number.overflow");
    EXPECT_EQ(code_of([&] { area(ellipse(1e200, 1e200)); }), "number.overflow");
    const Curve tiny = mapped(ellipse(1, 1), {0x1p-1040, 0, 0, 0x1p-1040, 0, 0});
    EXPECT_EQ(code_of([&] { measure(tiny); }), "number.overflow");
}

TEST(NumbersThatDoNotExist, AreEmptyWithANote) {
    const MeasureReport in_space = measure(space);
    EXPECT_FALSE(in_space.area);
    EXPECT_FALSE(in_space.area_positive);
    EXPECT_FALSE(in_space.turning);
    EXPECT_FALSE(in_space.inflections);
    EXPECT_TRUE(in_space.bending_energy);
    EXPECT_EQ(in_space.notes.size(), 2u);
    const MeasureReport cusp = measure(bezier({0, 0, 1, 1, 0, 1, 1, 0}));
    EXPECT_FALSE(cusp.bending_energy);
    EXPECT_FALSE(cusp.energy_length);
    EXPECT_FALSE(cusp.max_curvature);
    EXPECT_EQ(cusp.notes.size(), 3u);
    EXPECT_EQ(cusp.status, Status::met);
}

TEST(NumbersOfDegenerateCurves, AreFinite) {
    const MeasureReport point = measure(bezier({2, 3, 2, 3, 2, 3, 2, 3}));
    EXPECT_EQ(point.length, 0);
    EXPECT_EQ(point.area, 0.0);
    EXPECT_EQ(point.bending_energy, 0.0);
    EXPECT_EQ(point.turning, 0.0);
    EXPECT_EQ(point.centroid, (std::vector<double>{2, 3}));
    const MeasureReport on_a_line = measure(polyline(Points({0, 4, 1}, 1)));
    EXPECT_EQ(on_a_line.length, 7);
    EXPECT_FALSE(on_a_line.area);
    const MeasureReport tiny = measure(polyline(Points({0, 0, 5e-324, 0, 5e-324, 5e-324}, 2)));
    EXPECT_EQ(tiny.length, 1e-323);
    EXPECT_DOUBLE_EQ(length(polyline(Points({-8e307, 0, 8e307, 0}, 2))).value, 1.6e308);
}

TEST(Compare, SaysWhetherTheToleranceIsMet) {
    const Curve line = polyline(Points({0, 0, 10, 0}, 2));
    const Points points({1, 0.5, 2, -0.25}, 2);
    EXPECT_FALSE(compare(line, {points, {}}).within);
    const CompareReport met = compare(line, {points, absolute(0.5)});
    EXPECT_EQ(met.within, true);
    EXPECT_EQ(met.status, Status::met);
    EXPECT_EQ(met.max, 0.5);
    const CompareReport missed = compare(line, {points, relative(0.04)});
    EXPECT_EQ(missed.within, false);
    EXPECT_EQ(missed.status, Status::not_met);
    const Curve above = polyline(Points({0, 0.3, 10, 0.3}, 2));
    EXPECT_EQ(compare(line, {above, absolute(0.31)}).within, true);
    EXPECT_EQ(compare(line, {above, absolute(0.29)}).within, false);
}

}  // namespace measure_bad_test
}  // namespace batten
