#include "batten/make/natural_spline.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "batten/make/interpolate.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "random.hpp"

namespace batten {
namespace natural_spline_law_test {

PiecewiseCubic in_bulk(PointsView points) {
    std::vector<double> breaks(points.size()), block(8 * points.size());
    natural_spline(points, breaks, block);
    return PiecewiseCubic::power(block, 2, breaks, false);
}

void expect_the_curve_through(PointsView points) {
    InterpolateOptions options;
    options.method = Method::natural_chord;
    const Curve curve = curve_through(points, options);
    EXPECT_EQ(in_bulk(points), *curve.shape<PiecewiseCubic>()) << points.size();
}

// Rows are worked on in pairs from both ends, 256 at a time.
TEST(NaturalSpline, IsTheCurveOfNaturalChordBitForBit) {
    testing::Random random(1);
    for (const std::size_t n : {2u, 3u, 4u, 5u, 6u, 255u, 256u, 257u, 511u, 512u, 513u, 514u, 515u,
                                516u, 1025u, 5000u}) {
        expect_the_curve_through(random.points(n, 2));
    }
}

TEST(NaturalSpline, TakesChordsThatAreShortBesideTheWayWhereTheWayStillGrows) {
    expect_the_curve_through(Points({0, 0, 1e-17, 0, 1, 0, 2, 1}, 2));
    expect_the_curve_through(Points({0, 0, 0, 1e-30, 0, 1e-14, 3, 1, 4, 4}, 2));
}

TEST(NaturalSpline, ScalesWithThePointsExactly) {
    testing::Random random(2);
    const Points points = random.points(700, 2);
    const PiecewiseCubic curve = in_bulk(points);
    for (const double scale : {0x1p-300, 0x1p300}) {
        Points scaled = points;
        for (double& x : scaled.coordinates()) x *= scale;
        const PiecewiseCubic other = in_bulk(scaled);
        for (std::size_t i = 0; i < curve.pieces(); ++i) {
            ASSERT_EQ(other.breaks()[i + 1], scale * curve.breaks()[i + 1]);
            for (int k = 0; k < 2; ++k) {
                ASSERT_EQ(other.coefficients(1, k)[i], curve.coefficients(1, k)[i]);
                ASSERT_EQ(other.coefficients(2, k)[i] * scale, curve.coefficients(2, k)[i]);
                ASSERT_EQ(other.coefficients(3, k)[i] * scale * scale,
                          curve.coefficients(3, k)[i]);
            }
        }
    }
}

}  // namespace natural_spline_law_test
}  // namespace batten
