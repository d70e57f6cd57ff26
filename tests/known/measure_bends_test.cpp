#include <gtest/gtest.h>

#include <cmath>

#include "batten/measure/continuity.hpp"
#include "batten/measure/curvature.hpp"
#include "batten/measure/energy.hpp"
#include "curves.hpp"

namespace batten {
namespace measure_bends_test {

using namespace batten::testing;
constexpr double pi = std::numbers::pi;

const Curve cusp = bezier({0, 0, 1, 1, 0, 1, 1, 0});
const Curve near_cusp = bezier({0, 0, 1, 1, 0.001, 1, 1, 0});
const Curve loop = bezier({0, 0, 2, 1, -1, 1, 1, 0});
const Curve s_curve = bezier({0, 0, 1, 1, 2, -1, 3, 0});
const Curve space_cubic = bezier({0, 0, 0, 1, 2, 0, 0, 1, 3, 2, 0, 1}, 3);
const Curve there_and_back = bezier({0, 0, 3, 0, -2, 0, 1, 0});
const Curve soft_line = bezier({0, 0, 0, 0, 3, 0, 3, 0});
const Curve stopped_bend = bezier({0, 0, 0, 0, 1, 1, 2, 0});

TEST(Curvature, IsPositiveToTheLeftInThePlane) {
    EXPECT_NEAR(*curvature(ellipse(2, 2).jet(1, 2)), 0.5, 1e-15);
    EXPECT_NEAR(*curvature(mapped(ellipse(2, 2), {1, 0, 0, -1, 0, 0}).jet(1, 2)), -0.5, 1e-15);
}

TEST(Curvature, IsAMagnitudeInSpace) {
    // A helix of radius 3 and slope 4: 3 / 25.
    EXPECT_NEAR(*curvature(helix(3, 4).jet(0.3, 2)), 0.12, 1e-16);
}

TEST(Curvature, DoesNotExistWithoutSpeedAndDoesNotOverflow) {
    EXPECT_FALSE(curvature(soft_line.jet(0, 2)));
    const Curve huge = mapped(ellipse(2, 2), {0x1p900, 0, 0, 0x1p900, 0, 0});
    EXPECT_NEAR(*curvature(huge.jet(1, 2)), 0x1p-901, 0x1p-950);
}

TEST(BendingEnergy, OfACircleIsTwoPiByItsRadius) {
    for (const double radius : {1.0, 2.0, 1e-3}) {
        const Measured measured = *bending_energy(ellipse(radius, radius));
        EXPECT_NEAR(measured.value, 2 * pi / radius, 1e-14 * measured.value);
        EXPECT_LE(std::fabs(measured.value - 2 * pi / radius), measured.error);
        EXPECT_NEAR(energy_length(ellipse(radius, radius))->value, 4 * pi * pi, 1e-12);
    }
}

TEST(BendingEnergy, EqualsTwentyDigitIntegrals) {
    struct Case {
        Curve curve;
        double energy;
    };
    const std::vector<Case> cases{{loop, 26.466551195414260654},
                                  {s_curve, 2.4501960567258427628},
                                  {near_cusp, 14215134.366206778091},
                                  {ellipse(2, 1), 6.6360297521233013417},
                                  {space_cubic, 4.3355245088670990783}};
    for (const auto& [curve, energy] : cases) {
        const Measured measured = *bending_energy(curve);
        // Near the cusp the smallest speed, 1.25e-4, is known to 1e-12 of itself.
        EXPECT_NEAR(measured.value, energy, energy * (energy > 1e6 ? 1e-12 : 5e-15));
        EXPECT_LE(std::fabs(measured.value - energy), measured.error);
    }
    const double s = 2 / std::sqrt(5.0);
    EXPECT_NEAR(bending_energy(bezier({0, 0, 1.0 / 3, 0, 2.0 / 3, 1.0 / 3, 1, 1}))->value,
                2 * (s - s * s * s / 3), 1e-15);
}

TEST(BendingEnergy, OfStraightLinesIsZeroAndCornersDoNotCount) {
    EXPECT_EQ(bending_energy(polyline(Points({0, 0, 3, 4, 5, 0}, 2)))->value, 0);
    EXPECT_EQ(bending_energy(soft_line)->value, 0);
}

TEST(BendingEnergy, DoesNotExistThroughACuspOrAnInfiniteCurvature) {
    EXPECT_FALSE(bending_energy(cusp));
    EXPECT_FALSE(bending_energy(there_and_back));
    EXPECT_FALSE(bending_energy(stopped_bend));
    EXPECT_FALSE(energy_length(cusp));
    EXPECT_FALSE(pseudo_energy(mapped(cusp, rotation(0.3))));
}

TEST(BendingEnergy, ExistsWhereTheCurveStopsWithFiniteCurvature) {
    // (u^3, u^6) is the parabola y = x^2, at rest in its vertex.
    const auto f = [](double u, int order, std::span<double> out) {
        double x = u * u * u, y = x * x;
        for (int k = 0; k <= order; ++k) {
            out[2 * k] = x;
            out[2 * k + 1] = y;
            x = u == 0 ? (k == 2 ? 6.0 : 0.0) : x * (3 - k) / u;
            y = u == 0 ? 0.0 : y * (6 - k) / u;
        }
    };
    const double s = 2 / std::sqrt(5.0);
    const auto energy = bending_energy(CallableCurve{f, 2, {0, 1}, false});
    ASSERT_TRUE(energy);
    EXPECT_NEAR(energy->value, 2 * (s - s * s * s / 3), 1e-11);
}

TEST(PseudoEnergy, SumsEnergyTimesSquaredLengthOverThePieces) {
    const Curve two = waves({{{2, 1, 0}}, {{2, 1, -quarter}}}, {0, pi / 2, 2 * pi});
    // Arcs of angle a and radius r have E = a / r, L = a r.
    const double exact = 2 * (std::pow(pi / 2, 3) + std::pow(3 * pi / 2, 3));
    EXPECT_NEAR(pseudo_energy(two)->value, exact, 1e-13 * exact);
}

TEST(MaxCurvature, IsTheTrueMaximum) {
    const MaxCurvature of_loop = *max_curvature(loop);
    EXPECT_NEAR(of_loop.value, 8.665175126514052008, 1e-13);
    EXPECT_NEAR(of_loop.t, 0.3093891508672499592, 1e-12);
    const MaxCurvature of_s = *max_curvature(s_curve);
    EXPECT_NEAR(of_s.value, 1.2915752374585853706, 1e-14);
    EXPECT_NEAR(of_s.t, 0.14916374172712934869, 1e-12);
    const MaxCurvature of_near = *max_curvature(near_cusp);
    EXPECT_NEAR(of_near.value, 10666670.664004023818, 1e-5);
    EXPECT_NEAR(of_near.t, 0.50000006245837671108, 1e-12);
    const MaxCurvature in_space = *max_curvature(space_cubic);
    EXPECT_NEAR(in_space.value, 1.9970707479297609169, 1e-14);
    EXPECT_NEAR(in_space.t, 0.67352187477814690876, 1e-12);
    EXPECT_NEAR(max_curvature(ellipse(3, 1))->value, 3, 1e-12) << "a / b^2 at the long ends";
}

TEST(MaxCurvature, LooksAtBothSidesOfABreak) {
    // The parabola y = x^2 from its vertex, where it is most bent, after a straight line.
    Points points({-1, 0, 0, 0, 1, 1}, 2), start({1, 0, 1, 0}, 2), end({1, 0, 1, 2}, 2);
    const Curve curve = PiecewiseCubic::hermite(points, start, end, {0, 1, 2}, false);
    EXPECT_NEAR(max_curvature(curve)->value, 2, 1e-15);
    EXPECT_EQ(max_curvature(curve)->t, 1);
}

TEST(MaxCurvature, DoesNotExistAtACusp) {
    EXPECT_FALSE(max_curvature(cusp));
    EXPECT_FALSE(max_curvature(there_and_back));
    EXPECT_FALSE(max_curvature(stopped_bend));
    EXPECT_EQ(max_curvature(soft_line)->value, 0);
}

TEST(Turning, OfKnownCurves) {
    EXPECT_NEAR(turning(ellipse(3, 1)), 2 * pi, 1e-14);
    EXPECT_NEAR(turning(waves({{{1, 1, 0}}, {{1, 1, -quarter}}}, {0, 4 * pi})), 4 * pi, 1e-14);
    EXPECT_NEAR(turning(waves({{{1, 1, 0.3}}, {{0.5, 2, 0.6 - quarter}}}, {0, 2 * pi})), 0, 1e-14);
    EXPECT_NEAR(turning(loop), 5.3558900891779742445, 1e-14);
    EXPECT_NEAR(turning(near_cusp), -1.5712965768782299276, 1e-12);
    EXPECT_NEAR(turning(s_curve), 0, 1e-15);
}

TEST(Turning, IncludesCornersAndTheSeam) {
    EXPECT_NEAR(turning(polyline(Points({0, 0, 1, 0, 1, 1, 0, 1, 0, 0}, 2), true)), 2 * pi, 1e-15);
    EXPECT_NEAR(turning(polyline(Points({0, 0, 0, 1, 1, 1, 1, 0, 0, 0}, 2), true)), -2 * pi, 1e-15);
    EXPECT_NEAR(turning(polyline(Points({0, 0, 1, 0, 1, 1}, 2))), pi / 2, 1e-16);
}

TEST(Turning, CountsTurningBackAsHalfATurnToTheLeft) {
    EXPECT_NEAR(turning(polyline(Points({0, 0, 1, 0, 0.5, 0}, 2))), pi, 1e-16);
    EXPECT_NEAR(turning(cusp), 1.5 * pi, 1e-15) << "the arcs turn by pi / 2 in all";
    EXPECT_NEAR(turning(mapped(cusp, rotation(1))), 1.5 * pi, 1e-14);
    EXPECT_NEAR(turning(there_and_back), 2 * pi, 1e-15);
}

TEST(Inflections, AreWhereTheCurvatureChangesItsSign) {
    EXPECT_EQ(inflections(ellipse(3, 1)).size(), 0u);
    const std::vector<double> of_s = inflections(s_curve);
    ASSERT_EQ(of_s.size(), 1u);
    EXPECT_NEAR(of_s[0], 0.5, 1e-15);
    const std::vector<double> of_near = inflections(near_cusp);
    ASSERT_EQ(of_near.size(), 2u);
    // Zeros of x' y'' - y' x'' = 18 (a + b t + c t^2) by the quadratic formula, in 40 digits.
    EXPECT_NEAR(of_near[0], 0.49209133954562217, 1e-15);
    EXPECT_NEAR(of_near[1], 0.50790866045437777, 1e-15);
}

TEST(Inflections, AreSeenAcrossBreaksAndStraightStretches) {
    // Bends: left, right with the sign flipping at t = 1; right, straight, left.
    Points points({0, 0, 1, 0, 2, 0, 3, 0, 4, 0}, 2);
    Points start({1, -1, 1, 1, 1, 0, 1, -1}, 2), end({1, 1, 1, -1, 1, 0, 1, 1}, 2);
    const Curve curve = PiecewiseCubic::hermite(points, start, end, {0, 1, 2, 3, 4}, false);
    const std::vector<double> t = inflections(curve);
    ASSERT_EQ(t.size(), 2u);
    EXPECT_EQ(t[0], 1);
    EXPECT_EQ(t[1], 2.5);
}

TEST(Inflections, OfAClosedCurveIncludeTheSeam) {
    const Curve eight = waves({{{1, 1, -quarter}}, {{0.5, 2, -quarter}}}, {0, pi, 2 * pi});
    const std::vector<double> t = inflections(eight);
    ASSERT_EQ(t.size(), 2u);
    EXPECT_NEAR(t[0], 0, 1e-9);
    EXPECT_NEAR(t[1], pi, 1e-9);
}

TEST(Inflections, AreNotMadeByRoundingOnAStraightLine) {
    Points points(2), slopes(2);
    for (int i = 0; i < 50; ++i) {
        points.push_back(std::vector<double>{0.1 * i, 0.3 * i});
        slopes.push_back(std::vector<double>{0.1 + 0.01 * (i % 3), 3 * (0.1 + 0.01 * (i % 3))});
    }
    EXPECT_EQ(inflections(hermite(points, slopes)).size(), 0u);
}

struct TwoPieces {
    std::vector<double> left_slope, right_slope;
    double left_h, right_h;
};

/// Pieces over [0, h0] and [h0, h0 + h1] that meet in (1, 0).
std::string grade(const TwoPieces& p, std::vector<double> first = {1, 0},
                  std::vector<double> last = {1, 0}) {
    Points points({0, 0, 1, 0, 2, 0}, 2);
    Points start(2), end(2);
    start.push_back(first);
    start.push_back(p.right_slope);
    end.push_back(p.left_slope);
    end.push_back(last);
    const Curve curve = PiecewiseCubic::hermite(points, start, end,
                                                {0, p.left_h, p.left_h + p.right_h}, false);
    const std::vector<Joint> joints = continuity(curve);
    EXPECT_EQ(joints.size(), 1u);
    EXPECT_EQ(joints[0].t, p.left_h);
    return std::string(name_of(joints[0].continuity));
}

TEST(JointContinuity, IsWhatIsPresent) {
    EXPECT_EQ(grade({{1, 1}, {1, 0}, 1, 1}), "C0");
    EXPECT_EQ(grade({{1, 1}, {-1, -1}, 1, 1}), "C0") << "turned back";
    EXPECT_EQ(grade({{1, 1}, {2, 2}, 1, 1}), "G1");
    EXPECT_EQ(grade({{1, 1}, {1, 1}, 1, 1}, {1, 0}, {1, 1}), "C1");
    EXPECT_EQ(grade({{1, 0}, {2, 0}, 1, 1}), "G2") << "straight, the speed jumps";
    EXPECT_EQ(grade({{1, 1}, {1, 1}, 1, 1}, {1, -1}, {1, -1}), "C1") << "curvature changes sign";
    EXPECT_EQ(grade({{1, 0}, {1, 0}, 1, 1}), "C2");
    EXPECT_EQ(grade({{1, 1e-10}, {1, 0}, 1, 1}), "C2") << "within the tolerance";
    EXPECT_EQ(grade({{1, 1e-6}, {1, 0}, 1, 1}), "C0");
}

TEST(JointContinuity, OfACurveInTwoSpeedsIsG2) {
    // A circle whose second half is run through twice as fast.
    const auto f = [](double t, int order, std::span<double> out) {
        const double rate = t < 1 ? pi : 2 * pi;
        const double angle = t < 1 ? pi * t : pi + 2 * pi * (t - 1);
        for (int k = 0; k <= order; ++k) {
            out[2 * k] = std::pow(rate, k) * std::cos(angle + k * quarter);
            out[2 * k + 1] = std::pow(rate, k) * std::sin(angle + k * quarter);
        }
    };
    const std::vector<Joint> joints = continuity(CallableCurve{f, 2, {0, 1, 1.5}, true});
    ASSERT_EQ(joints.size(), 2u);
    EXPECT_EQ(joints[0].t, 0) << "the seam";
    EXPECT_EQ(joints[0].continuity, Continuity::G2);
    EXPECT_EQ(joints[1].t, 1);
    EXPECT_EQ(joints[1].continuity, Continuity::G2);
}

TEST(JointContinuity, TellsAGap) {
    const auto f = [](double t, int order, std::span<double> out) {
        for (int k = 0; k <= order; ++k) out[2 * k] = out[2 * k + 1] = 0;
        out[0] = t < 1 ? t : t + 1;
        if (order > 0) out[2] = 1;
    };
    const std::vector<Joint> joints = continuity(CallableCurve{f, 2, {0, 1, 2}, false});
    ASSERT_EQ(joints.size(), 1u);
    EXPECT_EQ(joints[0].continuity, Continuity::gap);
}

}  // namespace measure_bends_test
}  // namespace batten
