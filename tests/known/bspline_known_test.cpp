#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "batten/shape/bspline.hpp"
#include "batten/shape/curve.hpp"

namespace batten {
namespace bspline_known_test {

std::vector<double> values(const BSplineBasis& basis, double t, int order) {
    std::vector<double> out(static_cast<std::size_t>((order + 1) * (basis.degree() + 1)));
    basis.nonzero(t, order, out);
    return out;
}

void expect_near(const std::vector<double>& got, const std::vector<double>& want, double error) {
    ASSERT_EQ(got.size(), want.size());
    for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], want[i], error) << i;
}

TEST(BSplineBasis, OfUniformKnotsIsOneSixthFourSixthsOneSixth) {
    const BSplineBasis basis = BSplineBasis::periodic(std::vector<double>{0, 1, 2, 3, 4, 5}, 3);
    ASSERT_EQ(basis.size(), 5u);
    expect_near(values(basis, 2, 2), {1 / 6., 4 / 6., 1 / 6., 0, -0.5, 0, 0.5, 0, 1, -2, 1, 0},
                1e-15);
    expect_near(values(basis, 0.5, 0), {1 / 48., 23 / 48., 23 / 48., 1 / 48.}, 1e-15);
}

TEST(BSplineBasis, OfOneSpanIsBernsteins) {
    const BSplineBasis basis = BSplineBasis::over(std::vector<double>{2, 4}, 4);
    expect_near(values(basis, 2.5, 1),
                {81 / 256., 108 / 256., 54 / 256., 12 / 256., 1 / 256., -27 / 32., 0, 18 / 32.,
                 8 / 32., 1 / 32.},
                1e-15);
}

TEST(BSplineBasis, OfDegreeZeroSaysWhichSpanHoldsT) {
    const BSplineBasis basis({0, 1, 3}, 0);
    EXPECT_EQ(basis.size(), 2u);
    EXPECT_EQ(basis.span_of(0.5), 0u);
    EXPECT_EQ(basis.span_of(1), 1u);
    EXPECT_EQ(basis.span_of(3), 1u);
    EXPECT_EQ(values(basis, 1, 1), (std::vector<double>{1, 0}));
    EXPECT_EQ(basis.greville(), (std::vector<double>{0.5, 2}));
}

TEST(BSplineBasis, IsExactAtItsEnds) {
    const BSplineBasis basis({0.1, 0.1, 0.1, 0.1, 0.3, 0.7, 0.7, 0.7, 0.7}, 3);
    EXPECT_EQ(values(basis, 0.1, 0), (std::vector<double>{1, 0, 0, 0}));
    EXPECT_EQ(values(basis, 0.7, 0), (std::vector<double>{0, 0, 0, 1}));
}

TEST(BSplineBasis, HasDeBoorsExampleOfGrevilleAbscissae) {
    const BSplineBasis basis({0, 0, 0, 0, 1, 3, 3, 4, 4, 4, 4}, 3);
    expect_near(basis.greville(), {0, 1 / 3., 4 / 3., 7 / 3., 10 / 3., 11 / 3., 4}, 1e-15);
}

TEST(BSplineCurve, OfDegreeTwoWithWeightsIsAQuarterOfACircle) {
    const BSplineCurve curve(BSplineBasis::over(std::vector<double>{0, 1}, 2),
                             Points({1, 0, 1, 1, 0, 1}, 2), {1, std::sqrt(0.5), 1});
    for (const double t : {0.0, 0.1, 0.25, 0.5, 0.9, 1.0}) {
        const Jet jet = Curve(curve).jet(t, 3);
        const double radius = std::hypot(jet[0][0], jet[0][1]);
        const double speed = std::hypot(jet[1][0], jet[1][1]);
        const double cross = jet[1][0] * jet[2][1] - jet[1][1] * jet[2][0];
        // Curvature 1 along the curve: its derivative x' y''' - y' x''' = 3 speed (r'.r'').
        const double dot = jet[1][0] * jet[2][0] + jet[1][1] * jet[2][1];
        const double cross_3 = jet[1][0] * jet[3][1] - jet[1][1] * jet[3][0];
        EXPECT_NEAR(radius, 1, 2e-16);
        EXPECT_NEAR(jet[0][0] * jet[1][0] + jet[0][1] * jet[1][1], 0, 1e-15);
        EXPECT_NEAR(cross / std::pow(speed, 3), 1, 2e-15);
        EXPECT_NEAR(cross_3, 3 * speed * dot, 2e-14);
    }
    EXPECT_EQ(curve.degree(), std::nullopt);
}

TEST(InsertKnots, SplitsABezierCurveAsDeCasteljauDoes) {
    const BSplineCurve curve(BSplineBasis::over(std::vector<double>{0, 1}, 3),
                             Points({0, 0, 0, 1, 1, 1, 1, 0}, 2));
    const BSplineCurve halves = insert_knots(curve, std::vector<double>{0.5, 0.5, 0.5});
    EXPECT_EQ(Points(halves.control_points()),
              Points({0, 0, 0, .5, .25, .75, .5, .75, .75, .75, 1, .5, 1, 0}, 2));
}

TEST(ElevateDegree, PutsControlPointsAtThirds) {
    const BSplineCurve curve(BSplineBasis::over(std::vector<double>{0, 1}, 2),
                             Points({0, 0, 1, 3, 2, 0}, 2));
    const BSplineCurve cubic = elevate_degree(curve);
    const Points want({0, 0, 2 / 3., 2, 4 / 3., 2, 2, 0}, 2);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(cubic.control_points()(i, 0), want(i, 0), 5e-16);
        EXPECT_NEAR(cubic.control_points()(i, 1), want(i, 1), 5e-16);
    }
    EXPECT_EQ(cubic.control_points()(0, 0), 0);
    EXPECT_EQ(cubic.control_points()(3, 0), 2);
}

}  // namespace bspline_known_test
}  // namespace batten
