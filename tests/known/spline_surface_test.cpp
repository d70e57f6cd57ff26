#include <numbers>

#include "batten/measure/graph_bend.hpp"
#include "batten/shape/spline_surface.hpp"
#include "surface_samples.hpp"

namespace batten {
namespace spline_surface_test {

using namespace testing;

/// A cubic surface that the spline holds exactly.
double cubic(double x, double y) { return 1 + x - 2 * y + x * x * y - 0.5 * x * y * y * y; }

SplineSurface cubic_surface() {
    const SurfaceTable table = surface_of(cubic, 12, 11);
    FitSurfaceOptions options;
    options.sigma = 1;
    options.knots = SurfaceKnots::equal;
    options.intervals = {5, 4};
    return fit_surface(table.view(), options).surface;
}

TEST(SplineSurface, HasTheDerivativesOfAPolynomialItHolds) {
    const SplineSurface s = cubic_surface();
    for (const double x : {0.0, 0.21, 0.4, 0.77, 1.0}) {
        for (const double y : {0.0, 0.25, 0.6, 1.0}) {
            const HeightJet jet = s.jet(x, y);
            EXPECT_NEAR(jet.value, cubic(x, y), 1e-13);
            EXPECT_NEAR(jet.x, 1 + 2 * x * y - 0.5 * y * y * y, 1e-11);
            EXPECT_NEAR(jet.y, -2 + x * x - 1.5 * x * y * y, 1e-11);
            EXPECT_NEAR(jet.xx, 2 * y, 1e-9);
            EXPECT_NEAR(jet.xy, 2 * x - 1.5 * y * y, 1e-9);
            EXPECT_NEAR(jet.yy, -3 * x * y, 1e-9);
            EXPECT_NEAR(s(x, y, {0, 3}), -3 * x, 1e-7);
        }
    }
}

TEST(SplineSurface, IntegratesAPolynomialExactly) {
    const SplineSurface s = cubic_surface();
    EXPECT_NEAR(integral(s), 1 + 0.5 - 1 + 1.0 / 6 - 0.5 / 8, 1e-13);
    // The antiderivative of each term over [0.1, 0.7] x [0.3, 0.9].
    const auto power = [](double a, double b, int n) {
        return (std::pow(b, n + 1) - std::pow(a, n + 1)) / (n + 1);
    };
    const auto x = [&](int n) { return power(0.1, 0.7, n); };
    const auto y = [&](int n) { return power(0.3, 0.9, n); };
    const double want =
        x(0) * y(0) + x(1) * y(0) - 2 * x(0) * y(1) + x(2) * y(1) - 0.5 * x(1) * y(3);
    EXPECT_NEAR(integral(s, {{0.1, 0.7}, {0.3, 0.9}}), want, 1e-14);
}

TEST(SplineSurface, HasSectionsThatAreItsValues) {
    const SplineSurface s = cubic_surface();
    const SplineFunction along_x = section_at_y(s, 0.35), along_y = section_at_x(s, 0.62);
    for (const double t : {0.0, 0.3, 0.5, 1.0}) {
        EXPECT_NEAR(along_x(t), s(t, 0.35), 1e-14);
        EXPECT_NEAR(along_y(t), s(0.62, t), 1e-14);
    }
}

TEST(SplineSurface, IsTheSumOfItsBezierPatches) {
    const SplineSurface s = cubic_surface();
    const std::vector<BezierPatch> patches = bezier_patches(s);
    ASSERT_EQ(patches.size(), 20u);
    for (const BezierPatch& p : patches) {
        const double u = 0.3, v = 0.8;
        const auto bernstein = [](int i, double t) {
            constexpr double choose[] = {1, 3, 3, 1};
            return choose[i] * std::pow(t, i) * std::pow(1 - t, 3 - i);
        };
        double sum = 0;
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j) {
                sum += p.heights[static_cast<std::size_t>(4 * i + j)] * bernstein(i, u) *
                       bernstein(j, v);
            }
        }
        const double x = p.part.x.lo + u * p.part.x.length();
        const double y = p.part.y.lo + v * p.part.y.length();
        EXPECT_NEAR(sum, cubic(x, y), 1e-12);
        EXPECT_NEAR(p.heights.front(), cubic(p.part.x.lo, p.part.y.lo), 1e-12);
    }
}

TEST(GraphBend, IsThatOfASphereAndOfASaddle) {
    // z = sqrt(4 - x^2 - y^2) bends by 1/2 everywhere; its normal points from the centre.
    const double x = 0.4, y = -0.7, z = std::sqrt(4 - x * x - y * y);
    const HeightJet sphere{z, -x / z, -y / z, -(z * z + x * x) / (z * z * z), -x * y / (z * z * z),
                           -(z * z + y * y) / (z * z * z)};
    const GraphBend bend = graph_bend(sphere);
    EXPECT_NEAR(bend.gaussian, 0.25, 1e-15);
    EXPECT_NEAR(bend.mean, -0.5, 1e-15);
    EXPECT_NEAR(bend.normal[0], x / 2, 1e-15);
    EXPECT_NEAR(bend.normal[1], y / 2, 1e-15);
    EXPECT_NEAR(bend.normal[2], z / 2, 1e-15);
    const GraphBend saddle = graph_bend(HeightJet{0, 0, 0, 3, 0, -2});
    EXPECT_EQ(saddle.gaussian, -6);
    EXPECT_EQ(saddle.mean, 0.5);
    EXPECT_DOUBLE_EQ(saddle.largest, 3);
    EXPECT_DOUBLE_EQ(saddle.least, -2);
}

}  // namespace spline_surface_test
}  // namespace batten
