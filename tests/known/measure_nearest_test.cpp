#include <gtest/gtest.h>

#include <cmath>

#include "batten/measure/coordinate.hpp"
#include "batten/measure/deviation.hpp"
#include "batten/measure/line.hpp"
#include "batten/measure/nearest.hpp"
#include "curves.hpp"

namespace batten {
namespace measure_nearest_test {

using namespace batten::testing;
constexpr double pi = std::numbers::pi;

const Curve parabola = bezier({-1, 1, -1.0 / 3, -1.0 / 3, 1.0 / 3, -1.0 / 3, 1, 1});

TEST(NearestPoint, OnACircle) {
    const Curve circle = ellipse(2, 2);
    for (const double angle : {0.1, 1.0, 3.0, 5.5}) {
        const std::vector<double> inside{0.5 * std::cos(angle), 0.5 * std::sin(angle)};
        const Nearest near = nearest(circle, inside);
        EXPECT_NEAR(near.t, angle, 1e-12);
        EXPECT_NEAR(near.distance, 1.5, 1e-14);
        EXPECT_EQ(near.side, 1) << "left of a curve that turns left";
        const std::vector<double> outside{3 * std::cos(angle), 3 * std::sin(angle)};
        EXPECT_NEAR(nearest(circle, outside).distance, 1, 1e-14);
        EXPECT_EQ(nearest(circle, outside).side, -1);
    }
}

TEST(NearestPoint, IsTheBestOfSeveralFeet) {
    // From (0, 1) the parabola y = x^2 has its vertex at distance 1 and, nearer, x^2 = 1/2.
    const Nearest near = nearest(parabola, std::vector<double>{1e-6, 1});
    EXPECT_NEAR(near.distance, std::sqrt(0.75), 1e-6);
    EXPECT_NEAR(near.point[0], std::sqrt(0.5), 1e-6);
    EXPECT_EQ(near.side, 1);
    const Nearest low = nearest(parabola, std::vector<double>{0, 0.25});
    EXPECT_NEAR(low.distance, 0.25, 1e-15);
    EXPECT_NEAR(low.t, 0.5, 1e-12);
}

TEST(NearestPoint, AtEndsAndCorners) {
    const Curve corner = polyline(Points({0, 0, 1, 0, 1, 1}, 2));
    const Nearest outside = nearest(corner, std::vector<double>{2, -1});
    EXPECT_EQ(outside.t, 1);
    EXPECT_NEAR(outside.distance, std::sqrt(2.0), 1e-15);
    EXPECT_EQ(outside.side, -1);
    const Nearest ahead = nearest(corner, std::vector<double>{1, 3});
    EXPECT_EQ(ahead.t, 2);
    EXPECT_EQ(ahead.side, 0) << "straight ahead of the end";
    EXPECT_EQ(nearest(corner, std::vector<double>{0.9, 3}).side, 1);
    const Curve square = polyline(Points({0, 0, 1, 0, 1, 1, 0, 1, 0, 0}, 2), true);
    EXPECT_EQ(nearest(square, std::vector<double>{-1, -1}).side, -1) << "outside, at the seam";
    EXPECT_EQ(nearest(square, std::vector<double>{0.5, 0.4}).side, 1);
    EXPECT_EQ(nearest(square, std::vector<double>{0.25, 0}).side, 0) << "on the curve";
}

TEST(NearestPoint, InSpace) {
    const Curve line = polyline(Points({0, 0, 0, 1, 1, 1}, 3));
    const Nearest near = nearest(line, std::vector<double>{1, 0, 0});
    EXPECT_NEAR(near.distance, std::sqrt(2.0 / 3), 1e-15);
    EXPECT_NEAR(near.t, 1.0 / 3, 1e-15);
    EXPECT_EQ(near.side, 0);
}

TEST(LineIntersections, OfAnEllipse) {
    const auto hits = line_intersections(ellipse(2, 1), {{0, 0.5}, {3, 0}});
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_NEAR(hits[0].t, pi / 6, 1e-13);
    EXPECT_NEAR(hits[1].t, 5 * pi / 6, 1e-13);
    EXPECT_NEAR(hits[0].along, std::sqrt(3.0), 1e-13);
    EXPECT_NEAR(hits[1].along, -std::sqrt(3.0), 1e-13);
    EXPECT_NEAR(hits[0].point[1], 0.5, 1e-14);
    EXPECT_EQ(line_intersections(ellipse(2, 1), {{0, 1.5}, {3, 0}}).size(), 0u);
}

TEST(LineIntersections, ListTouchesJointsAndTheSeamOnce) {
    EXPECT_EQ(line_intersections(parabola, {{0, 0}, {1, 0}}).size(), 1u) << "touches the vertex";
    const Curve square = polyline(Points({0, 0, 1, 0, 1, 1, 0, 1, 0, 0}, 2), true);
    const auto diagonal = line_intersections(square, {{-1, -1}, {1, 1}});
    ASSERT_EQ(diagonal.size(), 2u);
    EXPECT_EQ(diagonal[0].t, 0);
    EXPECT_EQ(diagonal[1].t, 2);
    EXPECT_NEAR(diagonal[1].along, 2 * std::sqrt(2.0), 1e-15);
    const auto side = line_intersections(square, {{0, 0}, {1, 0}});
    ASSERT_EQ(side.size(), 2u) << "the ends of the side in the line";
    EXPECT_EQ(side[0].t, 0);
    EXPECT_EQ(side[1].t, 1);
}

TEST(CoordinateOfACurve, IsIntegratedExactly) {
    // y = x^2 over x = 2 t - 1: int y dt = 1/3.
    EXPECT_NEAR(integral(parabola, 1, {0, 1}), 1.0 / 3, 1e-16);
    EXPECT_NEAR(integral(parabola, 1, {0.5, 1}), 1.0 / 6, 1e-16);
    EXPECT_NEAR(integral(parabola, 1, {1, 0.5}), -1.0 / 6, 1e-16);
    EXPECT_EQ(integral(parabola, 1, {0.5, 0.5}), 0);
    const Curve high = mapped(parabola, {1, 0, 0, 1, 0, 1000});
    EXPECT_NEAR(integral(high, 1, {0, 0.5}), 500 + 1.0 / 6, 1e-13);
    EXPECT_NEAR(integral(ellipse(1, 1), 1, {0, pi}), 2, 1e-14);
}

TEST(CoordinateOfACurve, HasItsRoots) {
    const std::vector<double> t = roots(parabola, 1, 0.25);
    ASSERT_EQ(t.size(), 2u);
    EXPECT_NEAR(t[0], 0.25, 1e-16);
    EXPECT_NEAR(t[1], 0.75, 1e-16);
    EXPECT_EQ(roots(parabola, 1, 0).size(), 1u) << "a touch";
    EXPECT_EQ(roots(parabola, 1, -0.1).size(), 0u);
    EXPECT_EQ(roots(parabola, 1, 1).size(), 2u) << "both ends";
    const Curve wave = waves({{{1, 1, -quarter}}}, {0, 1, 9}, false);
    const std::vector<double> zeros = roots(wave, 0, 0);
    ASSERT_EQ(zeros.size(), 3u);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(zeros[i], i * pi, 1e-13);
}

TEST(CoordinateOfACurve, HasRootsAtTheJointsOnce) {
    const Curve zigzag = polyline(Points({-1, 0, 1, 0, 0, -1}, 1));
    EXPECT_EQ(roots(zigzag, 0, 0), (std::vector<double>{1, 3, 4})) << "3 to 4 lies at 0";
}

TEST(CoordinateOfACurve, KeepsItsDigitsBesideALargeValue) {
    const Curve outlier = polyline(Points({1e9, -1, 1e-6, -1e-6}, 1));
    const std::vector<double> t = roots(outlier, 0, 0);
    ASSERT_EQ(t.size(), 3u);
    EXPECT_NEAR(t[2], 2.5, 1e-15);
}

TEST(CoordinateOfACurve, HasItsExtrema) {
    const std::vector<Extremum> of_y = extrema(parabola, 1);
    ASSERT_EQ(of_y.size(), 1u);
    EXPECT_NEAR(of_y[0].t, 0.5, 1e-15);
    EXPECT_NEAR(of_y[0].value, 0, 1e-16);
    EXPECT_EQ(of_y[0].kind, ExtremumKind::minimum);
    EXPECT_EQ(extrema(parabola, 0).size(), 0u);
    const std::vector<Extremum> of_zigzag = extrema(polyline(Points({0, 2, 1, 1, 3}, 1)), 0);
    ASSERT_EQ(of_zigzag.size(), 2u);
    EXPECT_EQ(of_zigzag[0].t, 1);
    EXPECT_EQ(of_zigzag[0].kind, ExtremumKind::maximum);
    EXPECT_EQ(of_zigzag[1].t, 2.5) << "the middle of the flat stretch";
    EXPECT_EQ(of_zigzag[1].value, 1);
    EXPECT_EQ(range(polyline(Points({0, 2, 1, 1, 3}, 1)), 0), (Interval{0, 3}));
    EXPECT_NEAR(range(parabola, 1).lo, 0, 1e-16);
}

TEST(DeviationFromACurve, OfPointsOnBothSides) {
    const Curve line = polyline(Points({0, 0, 10, 0}, 2));
    const Deviation d = deviation(line, Points({1, 1, 2, -3, 4, 0, 6, 2}, 2));
    EXPECT_EQ(d.max, -3);
    EXPECT_NEAR(d.rms, std::sqrt(14.0 / 4), 1e-15);
    EXPECT_EQ(d.mean, 0);
    EXPECT_NEAR(d.at.t, 0.2, 1e-15);
    EXPECT_EQ(d.at.point, (std::vector<double>{2, -3}));
    // The end (10, 0) is farthest from the points: from (6, 2).
    EXPECT_NEAR(d.hausdorff, std::sqrt(20.0), 1e-15);
}

TEST(DeviationFromACurve, OfParallelLinesAndConcentricCircles) {
    const Curve line = polyline(Points({0, 0, 10, 0}, 2));
    const Curve above = polyline(Points({0, 0.5, 3, 0.5, 10, 0.5}, 2));
    const Deviation d = deviation(line, above);
    EXPECT_NEAR(d.max, 0.5, 1e-15);
    EXPECT_NEAR(d.rms, 0.5, 1e-14);
    EXPECT_NEAR(d.mean, 0.5, 1e-14);
    EXPECT_NEAR(d.hausdorff, 0.5, 1e-15);
    const Deviation rings = deviation(ellipse(2, 2), ellipse(3, 3));
    EXPECT_NEAR(rings.max, -1, 1e-13);
    EXPECT_NEAR(rings.mean, -1, 1e-12);
    EXPECT_NEAR(rings.hausdorff, 1, 1e-13);
}

TEST(DeviationFromACurve, MeansAreTakenAlongTheOtherCurve) {
    // d = y runs from 0 to 1 along the slanted line: mean 1/2, mean square 1/3.
    const Deviation d =
        deviation(polyline(Points({-9, 0, 9, 0}, 2)), polyline(Points({0, 0, 3, 1}, 2)));
    EXPECT_NEAR(d.mean, 0.5, 1e-14);
    EXPECT_NEAR(d.rms, std::sqrt(1.0 / 3), 1e-14);
    EXPECT_NEAR(d.max, 1, 1e-15);
}

TEST(HausdorffDistance, IsFoundInBothDirections) {
    // An ellipse in its circumscribed circle: largest at the short ends, 2 - 1.
    const Measured ring = hausdorff(ellipse(2, 1), ellipse(2, 2), absolute(1e-9));
    EXPECT_NEAR(ring.value, 1, 1e-9);
    EXPECT_LE(ring.error, 1e-9);
    // A short line and a long one: only the long one's end is far.
    const Curve short_line = polyline(Points({0, 0, 1, 0}, 2));
    const Curve long_line = polyline(Points({0, 0, 5, 0}, 2));
    EXPECT_NEAR(hausdorff(short_line, long_line).value, 4, 1e-15);
    EXPECT_NEAR(hausdorff(long_line, short_line).value, 4, 1e-15);
}

TEST(HausdorffDistance, SeesThePlaceBetweenTwoPoints) {
    // Halfway between the points of a regular hexagon a circle is farthest from them.
    Points hexagon(2);
    for (int i = 0; i < 6; ++i) {
        hexagon.push_back(std::vector<double>{std::cos(i * pi / 3), std::sin(i * pi / 3)});
    }
    const Measured measured = hausdorff(ellipse(1, 1), hexagon, absolute(1e-10));
    EXPECT_NEAR(measured.value, 2 * std::sin(pi / 12), 1e-10);
}

TEST(HausdorffDistance, WhereTheNearestPlaceJumps) {
    // A line crosses the middle between two parallel lines: the farthest place is there.
    const Curve gate = polyline(Points({-1, -5, -1, 5, 1, 5, 1, -5}, 2));
    const Curve bar = polyline(Points({-1.25, -1, 1.25, -1}, 2));
    const Deviation d = deviation(gate, bar, absolute(1e-9));
    EXPECT_NEAR(std::fabs(d.max), 1, 1e-9);
    EXPECT_NEAR(d.at.point[0], 0, 1e-8);
}

}  // namespace measure_nearest_test
}  // namespace batten
