#include <numbers>

#include "batten/measure/contours.hpp"
#include "batten/measure/curvature.hpp"
#include "batten/measure/length.hpp"
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
