#include "batten/make/pseudo_segment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "make/pseudo/segment/kernel.hpp"
#include "make/pseudo/segment/minima.hpp"
#include "shared.hpp"

namespace batten {
namespace pseudo_segment_test {

using testing::shared_csv;

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

/// E and L by the midpoint rule in extended precision: slow, and of another kind.
PseudoMeasures measured_slowly(const PseudoSegment& s, int steps) {
    const long double x0 = s.r0 * std::cos(s.theta0), y0 = s.r0 * std::sin(s.theta0);
    const long double x1 = s.r1 * std::cos(s.theta1), y1 = s.r1 * std::sin(s.theta1);
    const auto speed = [](long double t, long double chord, long double a, long double b) {
        return 6 * t * (1 - t) * chord + (1 - t) * (1 - 3 * t) * a + t * (3 * t - 2) * b;
    };
    const auto change = [](long double t, long double chord, long double a, long double b) {
        return (6 - 12 * t) * chord + (6 * t - 4) * a + (6 * t - 2) * b;
    };
    long double energy = 0;
    long double length = 0;
    for (int i = 0; i < steps; ++i) {
        const long double t = (i + 0.5L) / steps;
        const long double vx = speed(t, 1, x0, x1), vy = speed(t, 0, y0, y1);
        const long double n = vx * change(t, 0, y0, y1) - vy * change(t, 1, x0, x1);
        const long double v = std::sqrt(vx * vx + vy * vy);
        energy += n * n / (v * v * v * v * v) / steps;
        length += v / steps;
    }
    return {static_cast<double>(energy), static_cast<double>(length)};
}

TEST(PseudoSegment, MeasuresWhatTheDefinitionsSay) {
    for (const PseudoSegment& s : {PseudoSegment{0.7, -1.9, 0.8, 2.2},
                                   {2.9, 0.3, 1.6, 0.4},
                                   {-1.2, -1.2, 1.1, 1.1},
                                   {0.1, 3.0, 0.2, 4.0}}) {
        // The midpoint rule's error shrinks by 4 when the steps are doubled; it is extrapolated.
        const PseudoMeasures coarse = measured_slowly(s, 100000);
        const PseudoMeasures fine = measured_slowly(s, 200000);
        const double energy = fine.energy + (fine.energy - coarse.energy) / 3;
        const double length = fine.length + (fine.length - coarse.length) / 3;
        const PseudoMeasures m = measure(s);
        EXPECT_NEAR(m.energy, energy, 1e-12 * energy);
        EXPECT_NEAR(m.length, length, 1e-13 * length);
        EXPECT_DOUBLE_EQ(m.pseudo_energy, m.energy * m.length * m.length);
    }
}

TEST(PseudoSegment, MeasuresHairpins) {
    // A turn within 1e-3 of the chord: fixed nodes would miss nearly all of its energy.
    const PseudoSegment hairpin{0.001, -0.001, 3.01, 3.01};
    const PseudoMeasures coarse = measured_slowly(hairpin, 300000);
    const PseudoMeasures fine = measured_slowly(hairpin, 600000);
    const double energy = fine.energy + (fine.energy - coarse.energy) / 3;
    EXPECT_GT(energy, 1e3);
    EXPECT_NEAR(measure(hairpin).energy, energy, 1e-9 * energy);
}

TEST(PseudoSegment, KnowsTheEndCurvatures) {
    // Curvature at the ends of the cubic with control points 0, T0 / 3, (1, 0) - T1 / 3, (1, 0).
    const PseudoSegment s{0.4, -0.9, 1.3, 0.7};
    const double x0 = 1.3 * std::cos(0.4), y0 = 1.3 * std::sin(0.4);
    const double x1 = 0.7 * std::cos(-0.9), y1 = 0.7 * std::sin(-0.9);
    const double ax0 = 6 - 4 * x0 - 2 * x1, ay0 = -4 * y0 - 2 * y1;
    const double ax1 = -6 + 2 * x0 + 4 * x1, ay1 = 2 * y0 + 4 * y1;
    const PseudoMeasures m = measure(s);
    EXPECT_NEAR(m.start_curvature, (x0 * ay0 - y0 * ax0) / (1.3 * 1.3 * 1.3), 1e-14);
    EXPECT_NEAR(m.end_curvature, (x1 * ay1 - y1 * ax1) / (0.7 * 0.7 * 0.7), 1e-13);
    EXPECT_EQ(m.type, PseudoType::c);
    EXPECT_EQ(measure({0.4, 0.9, 1, 1}).type, PseudoType::s);
}

TEST(PseudoSegment, OfAStraightChordIsTheChord) {
    const PseudoSegment s = least_pseudo_segment(0, 0);
    EXPECT_EQ(s.r0, 1);
    EXPECT_EQ(s.r1, 1);
    const PseudoMeasures m = measure(s);
    EXPECT_EQ(m.pseudo_energy, 0);
    EXPECT_EQ(m.area, 0);
    EXPECT_NEAR(m.length, 1, 1e-15);
}

TEST(PseudoSegment, OfSmallAnglesFollowsItsSeries) {
    for (const double s : {1.0, 0.3, -0.2, -0.5, -1.0}) {
        const double t = 1e-3;
        const PseudoMeasures m = measure(least_pseudo_segment(t, s * t));
        const double s2 = s * s;
        const double fourth = 2.0 / 105 * (8 + 4 * s + 27 * s2 + 4 * s * s2 + 8 * s2 * s2);
        const double j = 4 * (1 + s + s2) * t * t + fourth * std::pow(t, 4);
        EXPECT_NEAR(m.pseudo_energy, j, 1e-11 * j) << s;
        EXPECT_NEAR(m.length, 1 + (2 - s + 2 * s2) / 30 * t * t, 2e-12) << s;
    }
}

TEST(CircularPoints, GiveTheMagnitudesStatedInTheSpecification) {
    struct Row {
        int n;
        double r, j;
    };
    for (const Row& row :
         {Row{3, 1.25082431538037, 5.26702644286778}, Row{8, 1.03256527771032, 0.632909315097892},
          Row{64, 1.00050210024913, 0.00964215701472149}}) {
        const PseudoSegment s = least_pseudo_segment(-pi / row.n, pi / row.n);
        EXPECT_NEAR(s.r0, row.r, 1e-13);
        EXPECT_EQ(s.r0, s.r1);
        EXPECT_NEAR(measure(s).pseudo_energy, row.j, 3e-15 * row.j);
    }
}

TEST(CircularPoints, GiveTheLengthsOfTheReferenceTable) {
    SKIP_UNLESS_SHARED("reference/pseudo-spline/circle.csv");
    const auto table = shared_csv("reference/pseudo-spline/circle.csv");
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const double n = table.number(i, "n");
        const PseudoSegment s = least_pseudo_segment(-pi / n, pi / n);
        const PseudoMeasures m = measure(s);
        const double chord = 2 * std::sin(pi / n);
        const double polygon = n / 2 * std::sin(2 * pi / n);
        EXPECT_NEAR(s.r0, table.number(i, "r"), 1e-11) << n;
        EXPECT_NEAR(n * chord * m.length, table.number(i, "length"), 1e-11) << n;
        EXPECT_NEAR(polygon - n * chord * chord * m.area, table.number(i, "area"), 1e-11) << n;
    }
}

TEST(LeastSegments, HaveTheMagnitudesOfTheReferenceGrid) {
    SKIP_UNLESS_SHARED("reference/pseudo-spline/grid10.csv");
    const auto table = shared_csv("reference/pseudo-spline/grid10.csv");
    int nodes = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        if (table.text(i, "type") == "x") continue;
        const double theta0 = table.number(i, "theta0_deg");
        const double theta1 = table.number(i, "theta1_deg");
        const PseudoSegment s = least_pseudo_segment(theta0 * degree, theta1 * degree);
        const PseudoMeasures m = measure(s);
        const double j = table.number(i, "J");
        ++nodes;
        EXPECT_NEAR(m.pseudo_energy, j, 1e-12 * j) << theta0 << ' ' << theta1;
        EXPECT_NEAR(s.r0, table.number(i, "r0"), 1e-9) << theta0 << ' ' << theta1;
        EXPECT_NEAR(s.r1, table.number(i, "r1"), 1e-9) << theta0 << ' ' << theta1;
        EXPECT_NEAR(m.length, table.number(i, "L"), 1e-9) << theta0 << ' ' << theta1;
        EXPECT_NEAR(m.area, table.number(i, "S"), 1e-9) << theta0 << ' ' << theta1;
        EXPECT_EQ(m.type == PseudoType::s ? "s" : "c", table.text(i, "type"))
            << theta0 << ' ' << theta1;
    }
    EXPECT_EQ(nodes, 1292);
}

TEST(Minima, OfShortArcsAreOneSymmetricAndTwoMirrored) {
    const auto minima = pseudo_minima(-pi / 8, pi / 8);
    ASSERT_GE(minima.size(), 3u);
    EXPECT_EQ(minima[0].r0, minima[0].r1);
    EXPECT_NEAR(std::max(minima[1].r0, minima[1].r1), 1.55073431196, 1e-10);
    EXPECT_NEAR(std::min(minima[1].r0, minima[1].r1), 0.37466626729, 1e-10);
    EXPECT_NEAR(minima[1].r0, minima[2].r1, 1e-12);
    EXPECT_NEAR(measure(minima[1]).pseudo_energy, 0.63328591007387, 1e-13);
}

TEST(Minima, AreEquallyLowOnTheJumpCurve) {
    SKIP_UNLESS_SHARED("reference/pseudo-spline/tie_curve.csv");
    const auto table = shared_csv("reference/pseudo-spline/tie_curve.csv");
    for (std::size_t i = 0; i < table.rows.size(); i += 9) {
        const double theta0 = table.number(i, "theta0_deg") * degree;
        const double theta1 = table.number(i, "theta1_tie_deg") * degree;
        const double j = table.number(i, "J");
        const auto c = pseudo::minimum_near(
            {theta0, theta1, table.number(i, "C_r0"), table.number(i, "C_r1")});
        const auto s = pseudo::minimum_near(
            {theta0, theta1, table.number(i, "S_r0"), table.number(i, "S_r1")});
        // theta1 is rounded to 1e-9 degrees.
        const double slope_c = pseudo::expand_all(c.segment).gradient[pseudo::angle1];
        const double slope_s = pseudo::expand_all(s.segment).gradient[pseudo::angle1];
        const double rounding = 6e-10 * degree;
        EXPECT_NEAR(c.pseudo_energy, s.pseudo_energy,
                    rounding * std::fabs(slope_c - slope_s) + 1e-13 * j)
            << theta0 / degree;
        EXPECT_NEAR(c.pseudo_energy, j, rounding * std::fabs(slope_c) + 1e-11 * j)
            << theta0 / degree;
        EXPECT_NEAR(c.segment.r0, table.number(i, "C_r0"), 1e-6) << theta0 / degree;
        EXPECT_NEAR(s.segment.r0, table.number(i, "S_r0"), 1e-6) << theta0 / degree;
    }
}

}  // namespace pseudo_segment_test
}  // namespace batten
