#include <numbers>

#include "batten/measure/contours.hpp"
#include "batten/measure/curvature.hpp"
#include "batten/measure/length.hpp"
#include "random.hpp"
#include "surface_samples.hpp"

namespace batten {
namespace contours_test {

using namespace testing;

SplineSurface exact(double (*f)(double, double), double strips = 4) {
    const SurfaceTable table = surface_of(f, 33, 33);
    FitSurfaceOptions options;
    options.sigma = 1;
    options.knots = SurfaceKnots::equal;
    options.intervals = {strips, strips};
    return fit_surface(table.view(), options).surface;
}

double bowl(double x, double y) { return (x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5); }
double saddle(double x, double y) { return (x - 0.5) * (y - 0.5); }

double signed_curvature(const Curve& curve, double t) {
    const Jet jet = curve.jet(t, 2);
    const double speed = std::hypot(jet[1][0], jet[1][1]);
    return (jet[1][0] * jet[2][1] - jet[1][1] * jet[2][0]) / (speed * speed * speed);
}

TEST(Contour, OfABowlIsItsCircle) {
    const std::vector<Contour> lines = contours(exact(bowl), 0.09);
    ASSERT_EQ(lines.size(), 1u);
    const Curve& circle = lines.front().curve;
    EXPECT_TRUE(circle.is_closed());
    EXPECT_NEAR(length(circle).value, 2 * std::numbers::pi * 0.3, 1e-6);
    for (const double t : circle.breaks()) {
        const std::vector<double> p = circle(t);
        EXPECT_NEAR(std::hypot(p[0] - 0.5, p[1] - 0.5), 0.3, 1e-13);
        // The higher ground is outside, on the left: the line turns right.
        EXPECT_NEAR(signed_curvature(circle, t), -1 / 0.3, 0.01);
    }
}

TEST(Contour, RunsFromBorderToBorderWhereItDoesNotClose) {
    const std::vector<Contour> lines = contours(exact(saddle), 0.04);
    ASSERT_EQ(lines.size(), 2u);
    for (const Contour& line : lines) {
        EXPECT_FALSE(line.curve.is_closed());
        for (const double t : line.curve.breaks()) {
            const std::vector<double> p = line.curve(t);
            EXPECT_NEAR(saddle(p[0], p[1]), 0.04, 1e-14);
        }
        const std::vector<double> a = line.curve(line.curve.domain().lo);
        EXPECT_TRUE(a[0] == 0 || a[0] == 1 || a[1] == 0 || a[1] == 1);
    }
}

TEST(Contour, PassesASaddleWithoutCrossingItself) {
    for (const double level : {-1e-9, 1e-9}) {
        const std::vector<Contour> lines = contours(exact(saddle, 3), level);
        EXPECT_EQ(lines.size(), 2u);
    }
}

TEST(Contour, StaysWithinItsToleranceBetweenJoints) {
    const SplineSurface s = exact([](double x, double y) {
        return std::sin(9 * x) * std::cos(7 * y) + x;
    }, 8);
    std::size_t points = 0;
    for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
        for (const double level : round_levels(s, 6)) {
            for (const Contour& line : contours(s, level, absolute(tolerance))) {
                for (std::size_t i = 0; i < line.curve.pieces(); ++i) {
                    const std::vector<double> p = line.curve(line.curve.piece(i).middle());
                    const HeightJet jet = s.jet(p[0], p[1]);
                    const double slope = std::hypot(jet.x, jet.y);
                    if (slope < 0.1) continue;
                    EXPECT_LE(std::fabs(jet.value - level) / slope, tolerance);
                    ++points;
                }
            }
        }
    }
    EXPECT_GT(points, 1000u);
}

/// a x^2 + b x + c y + d y^2 over the unit square, one patch: every cell of its lattice is 1/64 wide.
SplineSurface one_patch(double a, double b, double c, double d) {
    const BSplineBasis basis = BSplineBasis::over(std::vector<double>{0, 1}, 2);
    std::vector<double> heights;
    for (const double x : {0.0, 0.5, 1.0}) {
        for (const double y : {0.0, 0.5, 1.0}) {
            heights.push_back(a * (x == 1) + b * x + c * y + d * (y == 1));
        }
    }
    return {basis, basis, heights};
}

double farthest_from_level(const SplineSurface& s, const Contour& line) {
    double farthest = 0;
    for (std::size_t i = 0; i < line.curve.pieces(); ++i) {
        for (const double share : {0.2, 0.5, 0.8}) {
            const Interval piece = line.curve.piece(i);
            const std::vector<double> p = line.curve(piece.lo + share * piece.length());
            const HeightJet jet = s.jet(p[0], p[1]);
            farthest = std::max(farthest, std::fabs(jet.value - line.level) /
                                              std::hypot(jet.x, jet.y));
        }
    }
    return farthest;
}

TEST(Contour, GoesRoundATipThatIsNarrowerThanACell) {
    // y = 2000 (x - 0.508)^2 + 0.495: at y = 0.5, a line of the lattice, 0.0032 wide.
    const SplineSurface s = one_patch(2000, -2 * 2000 * 0.508, -1, 0);
    const double level = -0.495 - 2000 * 0.508 * 0.508;
    const std::vector<Contour> lines = contours(s, level, absolute(1e-7));
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].status, Status::met);
    EXPECT_LE(farthest_from_level(s, lines[0]), 1e-7);
    double lowest = 1;
    for (const double t : lines[0].curve.breaks()) lowest = std::min(lowest, lines[0].curve(t)[1]);
    EXPECT_NEAR(lowest, 0.495, 1e-4);
}

TEST(Contour, FindsAnIslandInsideOfACell) {
    const SplineSurface s = one_patch(1, -2 * 0.5071, -2 * 0.5069, 1);
    const double radius = 0.004;
    const double level = radius * radius - 0.5071 * 0.5071 - 0.5069 * 0.5069;
    const std::vector<Contour> lines = contours(s, level);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].curve.is_closed());
    EXPECT_NEAR(length(lines[0].curve).value, 2 * std::numbers::pi * radius, 1e-5);
}

TEST(Contour, StaysWithinItsToleranceOnRandomSurfaces) {
    Random random(7);
    std::size_t pieces = 0;
    for (int round = 0; round < 150; ++round) {
        const int degree = 1 + round % 4;
        const BSplineBasis x = BSplineBasis::over(even_places({0, 1}, 5), degree);
        const BSplineBasis y = BSplineBasis::over(std::vector<double>{0, 0.2, 0.3, 0.7, 1}, degree);
        std::vector<double> heights(x.size() * y.size());
        for (double& z : heights) z = random.within(-1, 1);
        const SplineSurface s(x, y, heights);
        for (const Contour& line : contours(s, random.within(-0.4, 0.4), absolute(1e-6))) {
            EXPECT_EQ(line.status, Status::met) << round;
            for (std::size_t i = 0; i < line.curve.pieces(); ++i) {
                const std::vector<double> p = line.curve(line.curve.piece(i).middle());
                const HeightJet jet = s.jet(p[0], p[1]);
                const double slope = std::hypot(jet.x, jet.y);
                if (slope < 0.1) continue;
                EXPECT_LE(std::fabs(jet.value - line.level) / slope, 1e-6) << round;
                ++pieces;
            }
        }
    }
    EXPECT_GT(pieces, 5000u);
}

TEST(Contour, PassesThroughASaddleAtItsLevel) {
    const SplineSurface s = one_patch(1, -1.014, 1.022, -1);  // saddle at (0.507, 0.511)
    const std::vector<Contour> lines = contours(s, s(0.507, 0.511));
    for (const Contour& line : lines) {
        EXPECT_EQ(line.status, Status::met);
        EXPECT_FALSE(line.curve.is_closed());
    }
    EXPECT_EQ(lines.size(), 2u);
}

TEST(Contour, OfAFlatSurfaceIsNothing) {
    const SplineSurface flat = exact([](double, double) { return 2.0; });
    EXPECT_TRUE(contours(flat, 1).empty());
    EXPECT_TRUE(round_levels(flat, 5).empty());
}

/// From noisy heights to the curvature of a level line.
TEST(Story, TheCurvatureOfALevelLineOfNoisyHeightsIsWithinOnePercent) {
    const auto dome = [](double x, double y) {
        return std::exp(-2 * ((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5)));
    };
    const SurfaceTable table = surface_of(dome, 150, 100, 0.002, 11);
    FitSurfaceOptions options;
    options.sigma = 0.002;
    options.degree = 5;  // curvature is made of second derivatives
    const SurfaceFit made = fit_surface(table.view(), options);
    const double radius = 0.3;
    const std::vector<Contour> lines =
        contours(made.surface, std::exp(-2 * radius * radius));
    ASSERT_EQ(lines.size(), 1u);
    const Curve& circle = lines.front().curve;
    ASSERT_TRUE(circle.is_closed());
    EXPECT_NEAR(length(circle).value, 2 * std::numbers::pi * radius, 1e-3);
    double largest = 0;
    for (int k = 0; k < 360; ++k) {
        const double t = circle.domain().hi * k / 360;
        largest = std::max(largest, std::fabs(signed_curvature(circle, t) * radius - 1));
    }
    EXPECT_LE(largest, 0.01);
    RecordProperty("largest", std::to_string(largest));
}

}  // namespace contours_test
}  // namespace batten
