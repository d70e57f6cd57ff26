#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "batten/base/error.hpp"
#include "batten/make/interpolate.hpp"
#include "batten/make/pseudo_spline.hpp"
#include "batten/measure/area.hpp"
#include "batten/measure/length.hpp"
#include "make/pseudo/free_end.hpp"
#include "make/pseudo/segment/minima.hpp"
#include "make/pseudo/tables/charts.hpp"
#include "make/pseudo/tables/ends.hpp"
#include "make/pseudo/tables/segments.hpp"
#include "num/patch_kernel.hpp"
#include "random.hpp"
#include "shared.hpp"

namespace batten {
namespace pseudo_tables_test {

using namespace pseudo;
using batten::testing::Random;
using batten::testing::shared_csv;

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

double to_node(double theta0, double theta1) {
    const double larger = std::fmax(std::fabs(theta0), std::fabs(theta1));
    const double smaller = std::fmin(std::fabs(theta0), std::fabs(theta1));
    return std::fmin(std::hypot(pi - larger, smaller), std::hypot(pi - larger, pi - smaller));
}

bool is_short_arc(double theta0, double theta1) {
    return std::fmax(std::fabs(theta0), std::fabs(theta1)) < 3 * degree &&
           std::fabs(theta0 + theta1) < 3 * degree;
}

TEST(TabulatedSegments, AreTheLeastOnes) {
    Random random(1);
    for (int i = 0; i < 1500; ++i) {
        const double theta0 = random.within(-pi, pi), theta1 = random.within(-pi, pi);
        if (to_node(theta0, theta1) < 2 * degree || is_short_arc(theta0, theta1)) continue;
        const TabulatedSegment s = tabulated_segment(theta0, theta1);
        const Minimum m = least_minimum(theta0, theta1);
        EXPECT_NEAR(s.pseudo_energy, m.pseudo_energy, 1e-12 * m.pseudo_energy)
            << theta0 << ' ' << theta1;
        EXPECT_NEAR(s.r0, m.segment.r0, 1e-8) << theta0 << ' ' << theta1;
        EXPECT_NEAR(s.r1, m.segment.r1, 1e-8) << theta0 << ' ' << theta1;
        EXPECT_NEAR(s.length, m.length, 1e-9) << theta0 << ' ' << theta1;
    }
}

TEST(TabulatedSegments, AreThoseOfTheReferenceGrid) {
    SKIP_UNLESS_SHARED("reference/pseudo-spline/grid10.csv");
    const auto table = shared_csv("reference/pseudo-spline/grid10.csv");
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        if (table.text(i, "type") == "x") continue;
        const double theta0 = table.number(i, "theta0_deg"), theta1 = table.number(i, "theta1_deg");
        const TabulatedSegment s = tabulated_segment(theta0 * degree, theta1 * degree);
        const double j = table.number(i, "J");
        EXPECT_NEAR(s.pseudo_energy, j, 1e-12 * j) << theta0 << ' ' << theta1;
        EXPECT_NEAR(s.r0, table.number(i, "r0"), 1e-8) << theta0 << ' ' << theta1;
        EXPECT_NEAR(s.r1, table.number(i, "r1"), 1e-8) << theta0 << ' ' << theta1;
        EXPECT_NEAR(s.length, table.number(i, "L"), 1e-9) << theta0 << ' ' << theta1;
    }
}

TEST(TabulatedSegments, OfShortArcsMeasureWhatTheyAreSaidTo) {
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const double t = std::pow(10.0, random.within(-6, -1.3));
        const double theta1 = t * (t * random.within(0, 2) - 1);
        const TabulatedSegment s = tabulated_segment(t, theta1);
        const PseudoMeasures m = measure(PseudoSegment{t, theta1, s.r0, s.r1});
        // r0, r1 are scaled down from larger arcs below 1.2 degrees.
        EXPECT_NEAR(s.pseudo_energy, m.pseudo_energy, 1e-11 * m.pseudo_energy) << t << ' ' << theta1;
        EXPECT_NEAR(s.length, m.length, 1e-10) << t << ' ' << theta1;
        // Nowhere above the minimiser, which there may miss the least by 1e-11.
        const double least = least_minimum(t, theta1).pseudo_energy;
        EXPECT_LT(s.pseudo_energy, least * (1 + 1e-12)) << t << ' ' << theta1;
        EXPECT_GT(s.pseudo_energy, least * (1 - 2e-11)) << t << ' ' << theta1;
    }
}

TEST(TabulatedSegments, AreMirroredAndReversedExactly) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const double a = random.within(-pi, pi), b = random.within(-pi, pi);
        const TabulatedSegment s = tabulated_segment(a, b), mirrored = tabulated_segment(-a, -b);
        const TabulatedSegment reversed = tabulated_segment(b, a);
        EXPECT_EQ(s.r0, mirrored.r0);
        EXPECT_EQ(s.r0, reversed.r1);
        EXPECT_EQ(s.pseudo_energy, reversed.pseudo_energy);
        const TabulatedSegment arc = tabulated_segment(a, -a);
        EXPECT_EQ(arc.r0, arc.r1);
    }
}

TEST(Charts, LeadBackToTheAngles) {
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        const double theta0 = random.within(1e-3, pi);
        const AnglePair a{theta0, theta0 * random.within(-1, 1)};
        const ChartPoint p = chart_point(a);
        const AnglePair b = angles_at(p);
        EXPECT_NEAR(a.theta0, b.theta0, 1e-15 * 8);
        EXPECT_NEAR(a.theta1, b.theta1, 1e-15 * 8);
        const double packed = packed_energy(p, a, 2.5 * theta0 * theta0);
        EXPECT_NEAR(unpacked_energy(p, a, packed), 2.5 * theta0 * theta0, 1e-14 * theta0 * theta0);
    }
}

TEST(TabulatedEnds, AreTheFreeOnes) {
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const double theta = random.within(-pi, pi);
        const TabulatedEnd end = tabulated_end(theta);
        const FreeEnd exact = free_end(theta);
        EXPECT_NEAR(end.pseudo_energy, exact.pseudo_energy, 1e-12 * exact.pseudo_energy) << theta;
        EXPECT_NEAR(end.theta1, exact.segment.theta1, 1e-10) << theta;
        EXPECT_NEAR(end.slope, exact.slope, 1e-9 * std::fabs(exact.slope)) << theta;
    }
}

TEST(TheTabulatedRuleOfThreePoints, GivesTheLeastTangent) {
    Random random(6);
    for (int i = 0; i < 300; ++i) {
        const ThreePoints three{random.within(-pi, pi), 1, std::exp(random.within(-3, 3))};
        for (const double p : {1.0, -1.0, 0.3}) {
            EXPECT_NEAR(tabulated_three_point_angle(three, p), three_point_angle(three, p).angle,
                        1e-9 * std::fabs(three.turn))
                << three.turn << ' ' << three.length1 << ' ' << p;
        }
    }
    EXPECT_EQ(tabulated_three_point_angle({102 * degree, 2, 2}, 1), 51 * degree);
}

TEST(PolynomialLevels, AgreeToRounding) {
    Random random(7);
    std::vector<double> c(12 * 12 * 4);
    for (double& x : c) x = random.within(-1, 1);
    for (const int size : {10, 12}) {
        const patches::Shape shape{size, size, 4};
        const auto plain = patches::polynomial_at(patches::Level::plain, shape, c.data(), 0.7, -0.9);
        for (const auto level : {patches::Level::avx2, patches::Level::avx512}) {
            if (!patches::is_offered(level)) continue;
            const auto fused = patches::polynomial_at(level, shape, c.data(), 0.7, -0.9);
            for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(plain[k], fused[k], 2e-14);
        }
    }
}

Points on_circle(int n) {
    Points points(2);
    for (int i = 0; i < n; ++i) {
        points.push_back(std::vector<double>{std::cos(2 * pi * i / n), std::sin(2 * pi * i / n)});
    }
    return points;
}

TEST(PseudoSpline, ThroughCircularPointsHasTheLengthAndAreaOfTheReferenceTable) {
    SKIP_UNLESS_SHARED("reference/pseudo-spline/circle.csv");
    const auto table = shared_csv("reference/pseudo-spline/circle.csv");
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const int n = static_cast<int>(table.number(i, "n"));
        const Points points = on_circle(n);
        const PseudoSpline s = pseudo_spline(points, {true});
        EXPECT_NEAR(s.length, table.number(i, "length"), 1e-9) << n;
        EXPECT_NEAR(s.area, table.number(i, "area"), 1e-9) << n;
    }
}

/// A walk with turns of all sizes.
Points walk(int n, unsigned seed) {
    Random random(seed);
    Points points(2);
    double x = 0, y = 0, direction = 0;
    for (int i = 0; i < n; ++i) {
        points.push_back(std::vector<double>{x, y});
        direction += random.within(-2, 2);
        const double step = random.within(0.3, 2);
        x += step * std::cos(direction);
        y += step * std::sin(direction);
    }
    return points;
}

TEST(PseudoSpline, IsTheCurveOfInterpolateBitForBit) {
    for (const bool closed : {false, true}) {
        const Points points = walk(60, 8);
        InterpolateOptions options;
        options.closed = closed;
        const Curve whole = curve_through(points, options);
        const PseudoSpline s = pseudo_spline(points, {closed});
        ASSERT_EQ(whole.pieces(), s.curve.pieces());
        for (std::size_t i = 0; i < whole.pieces(); ++i) {
            const Jet jet = whole.jet_on(i, static_cast<double>(i), 3);
            for (int k = 0; k < 2; ++k) {
                EXPECT_EQ(jet[1][static_cast<std::size_t>(k)], s.curve.coefficients(1, k)[i]);
                EXPECT_EQ(jet[2][static_cast<std::size_t>(k)], 2 * s.curve.coefficients(2, k)[i]);
            }
        }
        EXPECT_NEAR(s.length, length(whole).value, 1e-9 * s.length);
        EXPECT_NEAR(s.area, area(whole).value, 1e-7);
    }
}

TEST(PseudoSpline, IsThatOfTheMinimiserTo1e8) {
    for (const unsigned seed : {11u, 12u}) {
        const Points points = walk(60, seed);
        InterpolateOptions exact;
        exact.exact = true;
        const Curve slow = curve_through(points, exact), fast = curve_through(points, {});
        for (double t = 0; t < 59; t += 0.37) {
            const Jet a = slow.jet(t, 0), b = fast.jet(t, 0);
            EXPECT_NEAR(a[0][0], b[0][0], 2e-8) << t;
            EXPECT_NEAR(a[0][1], b[0][1], 2e-8) << t;
        }
    }
}

TEST(PseudoSpline, TimesAPowerOfTwoIsExact) {
    const Points points = walk(40, 9);
    Points large(points);
    for (double& x : large.coordinates()) x *= 0x1p30;
    const PseudoSpline s = pseudo_spline(points), l = pseudo_spline(large);
    EXPECT_EQ(l.length, 0x1p30 * s.length);
    EXPECT_EQ(l.area, 0x1p60 * s.area);
    EXPECT_EQ(l.pseudo_energy, 0x1p30 * s.pseudo_energy);
    EXPECT_EQ(l.curve.coefficients(3, 1)[7], 0x1p30 * s.curve.coefficients(3, 1)[7]);
}

TEST(PseudoSpline, WritesIntoTheCallersMemory) {
    const Points points = walk(40, 10);
    std::vector<double> block(8 * 40);
    const PseudoSplineMeasures m = pseudo_spline(points, {}, block);
    const PseudoSpline s = pseudo_spline(points);
    EXPECT_EQ(m.area, s.area);
    EXPECT_EQ(block[(2 * 3 + 1) * 40 + 5], s.curve.coefficients(3, 1)[5]);
    block.pop_back();
    EXPECT_THROW(pseudo_spline(points, {}, block), Error);
}

TEST(PseudoSpline, CanBeStoppedAndLeavesNothing) {
    const Points points = walk(5000, 13);
    PseudoSplineOptions options;
    options.progress = Progress([](double share) { return share < 0.5; });
    EXPECT_THROW(pseudo_spline(points, options), Cancelled);
}

}  // namespace pseudo_tables_test
}  // namespace batten
