#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "batten/make/pseudo_segment.hpp"
#include "make/pseudo/free_end.hpp"
#include "make/pseudo/segment/kernel.hpp"
#include "make/pseudo/segment/minima.hpp"
#include "make/pseudo/three_point.hpp"
#include "random.hpp"

namespace batten {
namespace pseudo_segment_law_test {

using testing::Random;

constexpr double pi = std::numbers::pi;

/// Angles all over the square, often near its diagonals, axes and corners.
double random_angle(Random& random) {
    const double places[] = {0, pi / 2, pi, -pi};
    if (random.whole(0, 3) > 0) return random.within(-pi, pi);
    return places[random.whole(0, 3)] + std::pow(10, random.within(-9, -1));
}

TEST(LeastSegments, HaveExactMirrorImagesAndReversals) {
    Random random(1);
    for (int k = 0; k < 300; ++k) {
        const double a = random_angle(random);
        const double b = random.whole(0, 4) == 0 ? -a : random_angle(random);
        const PseudoSegment s = least_pseudo_segment(a, b);
        const PseudoSegment mirrored = least_pseudo_segment(-a, -b);
        EXPECT_EQ(mirrored.r0, s.r0) << a << ' ' << b;
        EXPECT_EQ(mirrored.r1, s.r1) << a << ' ' << b;
        const PseudoSegment reversed = least_pseudo_segment(b, a);
        EXPECT_EQ(reversed.r0, s.r1) << a << ' ' << b;
        EXPECT_EQ(reversed.r1, s.r0) << a << ' ' << b;
    }
}

TEST(LeastSegments, AreSymmetricWhereTheirAnglesAre) {
    Random random(2);
    for (int k = 0; k < 200; ++k) {
        const double angle =
            random.whole(0, 1) == 0 ? random.within(0, 3.1) : std::pow(10, random.within(-12, 0));
        const PseudoSegment arc = least_pseudo_segment(angle, -angle);
        EXPECT_EQ(arc.r0, arc.r1) << angle;
        const PseudoSegment s_curve = least_pseudo_segment(angle, angle);
        EXPECT_EQ(s_curve.r0, s_curve.r1) << angle;
    }
}

TEST(LeastSegments, AreFiniteForAllAngles) {
    Random random(3);
    const double nodes[] = {-pi, 0, pi};
    for (int k = 0; k < 300; ++k) {
        const double push = random.whole(0, 2) == 0 ? 0 : std::pow(10, random.within(-17, -2));
        const double a = nodes[random.whole(0, 2)] + push;
        const double b = nodes[random.whole(0, 2)] + push * random.within(-1, 1);
        const auto m = pseudo::least_minimum(a, b);
        EXPECT_TRUE(m.is_converged) << a << ' ' << b;
        EXPECT_TRUE(m.segment.r0 > 0 && m.segment.r0 < 10) << a << ' ' << b;
        EXPECT_TRUE(m.segment.r1 > 0 && m.segment.r1 < 10) << a << ' ' << b;
        EXPECT_TRUE(std::isfinite(m.pseudo_energy) && std::isfinite(m.energy));
        EXPECT_TRUE(m.length > 1 - 1e-15 && m.length < 10) << a << ' ' << b;
    }
}

TEST(LeastSegments, AreUnchangedByFullTurns) {
    const PseudoSegment s = least_pseudo_segment(0.75, -1.5);
    const PseudoSegment turned = least_pseudo_segment(0.75 + 2 * pi, -1.5 - 4 * pi);
    EXPECT_NEAR(turned.r0, s.r0, 1e-13);
    EXPECT_NEAR(turned.r1, s.r1, 1e-13);
}

TEST(LeastSegments, AreNoHigherThanAnythingAScanFinds) {
    Random random(4);
    for (int k = 0; k < 60; ++k) {
        const bool is_in_pocket = k % 3 == 0;
        const double a = is_in_pocket ? random.within(0.87, 1.26) : random.within(0, pi);
        const double b = is_in_pocket ? random.within(-0.6, -0.4) : a * random.within(-1, 1);
        const double least = pseudo::least_minimum(a, b).pseudo_energy;
        for (int i = 0; i < 12; ++i) {
            const double r0 = std::exp(random.within(-4, 3));
            const double r1 = std::exp(random.within(-4, 3));
            const double found = pseudo::minimum_near({a, b, r0, r1}).pseudo_energy;
            EXPECT_LE(least, found * (1 + 2e-14)) << a << ' ' << b;
        }
    }
}

TEST(LeastSegments, HaveNoSlope) {
    Random random(5);
    for (int k = 0; k < 100; ++k) {
        const PseudoSegment s = least_pseudo_segment(random.within(-3, 3), random.within(-3, 3));
        const auto j = pseudo::expand_magnitudes(s);
        EXPECT_LT(std::fabs(j.gradient[0]) + std::fabs(j.gradient[1]), 1e-12 * j.value);
        const double determinant =
            j.hessian[0][0] * j.hessian[1][1] - j.hessian[0][1] * j.hessian[1][0];
        EXPECT_GT(determinant, 0);
    }
}

TEST(Derivatives, AreLimitsOfDifferences) {
    Random random(6);
    for (int k = 0; k < 50; ++k) {
        const double x[] = {random.within(-1, 1), random.within(-1, 1), random.within(-3, 3),
                            random.within(-3, 3)};
        const auto expand = [&](int variable, double step) {
            double y[] = {x[0], x[1], x[2], x[3]};
            y[variable] += step;
            return pseudo::expand_all({y[2], y[3], std::exp(y[0]), std::exp(y[1])});
        };
        const auto j = expand(0, 0);
        // A pole of the integrand near [0, 1] makes differences worthless.
        if (!(j.value < 1e3)) continue;
        const double h = 1e-5;
        for (int a = 0; a < 4; ++a) {
            const auto up = expand(a, h), down = expand(a, -h);
            EXPECT_NEAR((up.value - down.value) / (2 * h), j.gradient[a], 1e-4 * j.value);
            for (int b = 0; b < 4; ++b) {
                EXPECT_NEAR((up.gradient[b] - down.gradient[b]) / (2 * h), j.hessian[a][b],
                            1e-3 * j.value);
            }
        }
    }
}

using Vector = std::complex<double>;

/// E and L of the cubic with these control points.
PseudoMeasures measured(const std::array<Vector, 4>& p) {
    const Vector chord = p[3] - p[0];
    const double length = std::abs(chord);
    const Vector start = 3.0 * (p[1] - p[0]) / chord, end = 3.0 * (p[3] - p[2]) / chord;
    PseudoMeasures m = measure({std::arg(start), std::arg(end), std::abs(start), std::abs(end)});
    m.energy /= length;
    m.length *= length;
    return m;
}

TEST(Measures, OfACurveAreThoseOfItsPartsTogether) {
    Random random(11);
    for (int k = 0; k < 300; ++k) {
        // The second control point comes near the chord's middle: hairpins of all widths.
        const double width = std::pow(10, random.within(-4, 0));
        const std::array<Vector, 4> p{Vector(0), Vector(random.within(-3, 3), width),
                                      Vector(random.within(-3, 3), width * random.within(-2, 2)),
                                      Vector(1)};
        const double t = random.within(0.2, 0.8);
        const auto between = [t](Vector a, Vector b) { return (1 - t) * a + t * b; };
        const Vector a = between(p[0], p[1]), b = between(p[1], p[2]), c = between(p[2], p[3]);
        const Vector ab = between(a, b), bc = between(b, c), middle = between(ab, bc);
        const PseudoMeasures whole = measured(p);
        const PseudoMeasures first = measured({p[0], a, ab, middle});
        const PseudoMeasures second = measured({middle, bc, c, p[3]});
        EXPECT_NEAR(first.length + second.length, whole.length, 1e-14 * whole.length);
        // At a hairpin of least speed v, E grows as 1 / v^2 and rounding as 1 / v; on nearly
        // straight curves E falls as the square of the heights, which keep their rounding.
        const double bend = std::sqrt(whole.energy * whole.length);
        const double rounding = 1e-15 * (10 + bend + 10 / bend);
        EXPECT_NEAR(first.energy + second.energy, whole.energy, rounding * whole.energy);
    }
}

TEST(FreeEnd, IsOddInItsAngleAndEvenInItsEnergy) {
    Random random(7);
    for (int k = 0; k < 100; ++k) {
        const double theta = random_angle(random);
        const auto end = pseudo::free_end(theta), mirrored = pseudo::free_end(-theta);
        if (std::fabs(theta) == pi) continue;  // -pi is pi
        EXPECT_EQ(mirrored.pseudo_energy, end.pseudo_energy) << theta;
        EXPECT_EQ(mirrored.segment.theta1, -end.segment.theta1) << theta;
        EXPECT_EQ(mirrored.slope, -end.slope) << theta;
    }
}

TEST(FreeEnd, IsTheLeastSegmentOfItsAngles) {
    Random random(8);
    for (int k = 0; k < 60; ++k) {
        const double theta = random.within(0, pi);
        const auto end = pseudo::free_end(theta);
        const auto least = pseudo::least_minimum(theta, end.segment.theta1);
        EXPECT_NEAR(end.pseudo_energy, least.pseudo_energy, 1e-13 * least.pseudo_energy) << theta;
        for (const double turn : {-1.0, -0.1, -1e-3, 1e-3, 0.1, 1.0}) {
            const auto other = pseudo::least_minimum(theta, end.segment.theta1 + turn);
            EXPECT_LT(end.pseudo_energy, other.pseudo_energy) << theta << ' ' << turn;
        }
    }
}

TEST(FreeEnd, HasTheSlopeOfItsEnergy) {
    for (const double theta : {0.01, 0.4, 0.95, 1.1, 2.0, 3.0}) {
        const double h = 1e-5;
        const auto end = pseudo::free_end(theta);
        const auto up = pseudo::free_end_near(theta + h, end.segment);
        const auto down = pseudo::free_end_near(theta - h, end.segment);
        EXPECT_NEAR((up.pseudo_energy - down.pseudo_energy) / (2 * h), end.slope, 1e-7 * end.slope);
        EXPECT_NEAR((up.slope - down.slope) / (2 * h), end.curvature, 1e-6 * end.curvature);
    }
}

TEST(ThreePointRule, HasExactMirrorImagesReversalsAndScales) {
    Random random(9);
    for (int k = 0; k < 40; ++k) {
        const double turn = random.within(0, pi);
        const double l0 = std::exp(random.within(-2, 2)), l1 = std::exp(random.within(-2, 2));
        const double p = random.within(-1, 1);
        const double angle = pseudo::three_point_angle({turn, l0, l1}, p).angle;
        EXPECT_EQ(pseudo::three_point_angle({-turn, l0, l1}, p).angle, -angle);
        EXPECT_EQ(pseudo::three_point_angle({turn, 1024 * l0, 1024 * l1}, p).angle, angle);
        const double reversed = pseudo::three_point_angle({turn, l1, l0}, p).angle;
        EXPECT_NEAR(turn - reversed, angle, 1e-15);
        EXPECT_TRUE(0 <= angle && angle <= turn);
    }
}

TEST(ThreePointRule, FollowsTheHeavyChordHoweverHeavy) {
    for (const double p : {1.0, 8.0}) {
        for (const double ratio : {1e-5, 1e-50, 1e-300}) {
            const double angle = pseudo::three_point_angle({1.0, 1, ratio}, p).angle;
            EXPECT_TRUE(0 <= angle && angle < 1e-4) << ratio;
            const double light = pseudo::three_point_angle({1.0, 1, ratio}, -p).angle;
            EXPECT_TRUE(1 - 1e-4 < light && light <= 1) << ratio;
        }
    }
}

TEST(ThreePointRule, IsLeastOnTheWholeCircle) {
    Random random(10);
    for (int k = 0; k < 8; ++k) {
        const pseudo::ThreePoints three{random.within(-pi, pi), 1, std::exp(random.within(-1, 1))};
        const double p = k % 2 == 0 ? 1 : -1;
        const double weight = std::pow(three.length1, p);
        const double least = pseudo::three_point_angle(three, p).energy;
        for (int i = 0; i < 60; ++i) {
            const double angle = -pi + 2 * pi * i / 60;
            const double w = pseudo::free_end(angle).pseudo_energy +
                             weight * pseudo::free_end(angle - three.turn).pseudo_energy;
            EXPECT_LE(least, w * (1 + 1e-13)) << three.turn << ' ' << three.length1;
        }
        const auto rival = pseudo::three_point_rival(three, p);
        if (rival) {
            EXPECT_GE(rival->energy, least);
        }
    }
}

}  // namespace pseudo_segment_law_test
}  // namespace batten
