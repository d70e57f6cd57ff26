#include "batten/measure/surface_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random.hpp"

namespace batten {
namespace surface_measures_test {

/// a + b x + c y + d x y + e x^2 over [0, 1] x [0, 2], in 3 x 2 patches: exact as a spline.
SplineSurface quadric(double b, double c, double d, double e) {
    const BSplineBasis x = BSplineBasis::over(std::vector<double>{0, 0.25, 0.5, 1}, 2);
    const BSplineBasis y = BSplineBasis::over(std::vector<double>{0, 1.5, 2}, 2);
    // The blossom at each function's inner knots.
    std::vector<double> heights;
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = 0; j < y.size(); ++j) {
            const double s = x.knots()[i + 1], t = x.knots()[i + 2];
            const double middle = (s + t) / 2, across = (y.knots()[j + 1] + y.knots()[j + 2]) / 2;
            heights.push_back(b * middle + c * across + d * middle * across + e * s * t);
        }
    }
    return {x, y, heights};
}

TEST(SurfaceMeasures, GiveTheAreaOfAPlaneAndOfAParabolicCylinder) {
    const Measured plane = surface_area(quadric(3, -4, 0, 0));
    EXPECT_NEAR(plane.value, 2 * std::sqrt(26), 1e-13);
    EXPECT_LE(plane.error, 1e-13);
    const double exact = std::sqrt(2) + std::asinh(1.0);
    const Measured cylinder = surface_area(quadric(0, 0, 0, 0.5));
    EXPECT_NEAR(cylinder.value, exact, 1e-9);
    EXPECT_LE(std::fabs(cylinder.value - exact), cylinder.error + 1e-14);
}

TEST(SurfaceMeasures, GiveVolumeHeightsAndBendsOfASaddle) {
    const SurfaceReport r = measure_surface(quadric(0, 0, 1, 0));
    EXPECT_EQ(r.status, Status::met);
    EXPECT_NEAR(r.integral, 1, 1e-14);
    EXPECT_NEAR(r.height.least.value, 0, 1e-15);
    EXPECT_NEAR(r.height.largest.value, 2, 1e-14);
    EXPECT_EQ(r.height.largest.x, 1);
    EXPECT_EQ(r.height.largest.y, 2);
    // K = -1 / (1 + x^2 + y^2)^2
    EXPECT_NEAR(r.gaussian_curvature.least.value, -1, 1e-12);
    EXPECT_NEAR(r.gaussian_curvature.largest.value, -1.0 / 36, 1e-12);
    EXPECT_EQ(r.gaussian_curvature.least.x, 0);
    // H = -x y / (1 + x^2 + y^2)^(3/2): least inside the y side of x = 1, at y = 1.
    EXPECT_NEAR(r.mean_curvature.least.value, -1 / std::sqrt(27), 1e-12);
    EXPECT_NEAR(r.mean_curvature.least.y, 1, 1e-6);
    EXPECT_NEAR(r.mean_curvature.largest.value, 0, 1e-15);
}

TEST(SurfaceMeasures, FindAPeakBetweenTheLattice) {
    // 0.37 x - x^2 / 2 + y / 8 peaks at x = 0.37.
    const SurfaceReport r = measure_surface(quadric(0.37, 0.125, 0, -0.5));
    EXPECT_NEAR(r.height.largest.x, 0.37, 1e-7);
    EXPECT_NEAR(r.height.largest.value, 0.37 * 0.37 / 2 + 0.25, 1e-14);
}

TEST(SurfaceMeasures, FindTheHighestOfManyPeaks) {
    testing::Random random(5);
    for (int round = 0; round < 120; ++round) {
        const int x_degree = random.whole(1, 5), y_degree = random.whole(1, 5);
        const BSplineBasis x = BSplineBasis::over(even_places({0, 1}, 6), x_degree);
        const BSplineBasis y = BSplineBasis::over(even_places({0, 1}, 6), y_degree);
        std::vector<double> heights(x.size() * y.size());
        for (double& z : heights) z = random.within(-1, 1);
        const SplineSurface s(x, y, heights);
        const SurfaceRange range = measure_surface(s, absolute(1e9)).height;
        const std::vector<double> places = even_places({0, 1}, 151);
        const Grid seen = s.evaluate(places, places);
        const std::span<const double> z = seen.view().values();
        const auto [least, largest] = std::minmax_element(z.begin(), z.end());
        EXPECT_GE(range.largest.value, *largest - 1e-12) << round;
        EXPECT_LE(range.least.value, *least + 1e-12) << round;
        EXPECT_EQ(range.largest.value, s(range.largest.x, range.largest.y));
    }
}

}  // namespace surface_measures_test
}  // namespace batten
