#include "batten/shape/spline_function.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "random.hpp"
#include "shared.hpp"

namespace batten {
namespace spline_function_test {

/// x^3 - 2 x on [-2, 3] as a cubic spline with some knots: coefficients by the blossom.
SplineFunction cubic() {
    const std::vector<double> knots{-2, -2, -2, -2, -1, 0.5, 0.5, 2, 3, 3, 3, 3};
    std::vector<double> c;
    for (std::size_t j = 0; j + 4 < knots.size(); ++j) {
        const double a = knots[j + 1], b = knots[j + 2], d = knots[j + 3];
        c.push_back(a * b * d - 2 * (a + b + d) / 3);
    }
    return {knots, c, 3};
}

TEST(SplineFunction, GivesValuesAndDerivativesOfAPolynomial) {
    const SplineFunction s = cubic();
    for (double x = -2.5; x <= 3.5; x += 0.125) {
        EXPECT_NEAR(s(x), x * x * x - 2 * x, 1e-13);
        EXPECT_NEAR(s(x, 1), 3 * x * x - 2, 1e-13);
        EXPECT_NEAR(s(x, 2), 6 * x, 1e-13);
        EXPECT_NEAR(s(x, 3), 6, 1e-12);
        EXPECT_EQ(s(x, 4), 0);
    }
}

TEST(SplineFunction, GivesIntegralRootsAndExtrema) {
    const SplineFunction s = cubic();
    EXPECT_NEAR(integral(s, {-2, 3}), (81 - 16) / 4.0 - (9 - 4), 1e-12);
    EXPECT_NEAR(integral(s, {0, 1}), -0.75, 1e-13);
    const std::vector<double> zeros = roots(s);
    ASSERT_EQ(zeros.size(), 3u);
    EXPECT_NEAR(zeros[0], -std::numbers::sqrt2, 1e-15 * 4);
    EXPECT_NEAR(zeros[1], 0, 1e-15);
    EXPECT_NEAR(zeros[2], std::numbers::sqrt2, 1e-15 * 4);
    const std::vector<double> turns = extrema(s);
    ASSERT_EQ(turns.size(), 2u);
    EXPECT_NEAR(turns[0], -std::sqrt(2 / 3.0), 1e-15);
    EXPECT_NEAR(turns[1], std::sqrt(2 / 3.0), 1e-15);
    ASSERT_EQ(roots(s, -4).size(), 1u);
    EXPECT_EQ(roots(s, -4)[0], -2);
    EXPECT_TRUE(roots(s, 100).empty());
}

TEST(SplineFunction, FindsRootsAtJointsOnce) {
    // A roof with its foot points on knots, and a flat stretch on the level.
    const SplineFunction roof({0, 0, 1, 2, 3, 4, 4}, {0, 1, 0, 0, 1}, 1);
    const std::vector<double> zeros = roots(roof);
    ASSERT_EQ(zeros.size(), 3u);
    EXPECT_EQ(zeros[0], 0);
    EXPECT_EQ(zeros[1], 2);
    EXPECT_EQ(zeros[2], 3);
    const std::vector<double> half = roots(roof, 0.5);
    ASSERT_EQ(half.size(), 3u);
    EXPECT_DOUBLE_EQ(half[2], 3.5);
}

TEST(SplineFunction, SeesAJump) {
    const SplineFunction steps({0, 1, 2, 3}, {-1, 1, -1}, 0);
    EXPECT_EQ(steps(1), 1);
    EXPECT_EQ(steps(0.999), -1);
    EXPECT_EQ(steps(3), -1);
    const std::vector<double> zeros = roots(steps);
    ASSERT_EQ(zeros.size(), 2u);
    EXPECT_EQ(zeros[0], 1);
    EXPECT_EQ(zeros[1], 2);
}

TEST(SplineFunction, FindsThePieceWhateverTheKnots) {
    testing::Random random(3);
    std::vector<double> knots{0};
    for (int i = 0; i < 300; ++i) {
        knots.push_back(knots.back() + std::exp(random.within(-12, 3)));
    }
    const std::vector<double> c(300, 1.0);
    const SplineFunction s(knots, c, 0);
    for (int i = 0; i < 5000; ++i) {
        const bool is_knot = i % 3 == 0;
        const double x = is_knot ? knots[static_cast<std::size_t>(random.whole(0, 300))]
                                 : random.within(0, knots.back());
        const auto found = std::upper_bound(knots.begin() + 1, knots.end() - 1, x);
        EXPECT_EQ(s.piece_of(x), static_cast<std::size_t>(found - knots.begin()) - 1);
    }
    EXPECT_EQ(s.piece_of(-1), 0u);
    EXPECT_EQ(s.piece_of(1e300), 299u);
}

TEST(SplineFunction, BecomesCurveAndCubicPieces) {
    const SplineFunction s = cubic();
    const Curve curve = graph(s);
    const Curve pieces = graph_cubic(s);
    for (double x = -2; x <= 3; x += 0.25) {
        for (const Curve& c : {curve, pieces}) {
            const Jet jet = c.jet(x, 1);
            EXPECT_NEAR(jet[0][0], x, 1e-14);
            EXPECT_NEAR(jet[0][1], x * x * x - 2 * x, 1e-13);
            EXPECT_NEAR(jet[1][0], 1, 1e-13);
            EXPECT_NEAR(jet[1][1], 3 * x * x - 2, 1e-12);
        }
    }
}

TEST(SplineFunction, WithAJumpHasADerivativeOnBothSides) {
    // x^2 up to 1, then 5 - x: degree 2, the knot 1 stands three times.
    const SplineFunction s({0, 0, 0, 1, 1, 1, 2, 2, 2}, {0, 0, 1, 4, 3.5, 3}, 2);
    const SplineFunction slope = derivative(s);
    EXPECT_EQ(slope.degree(), 1);
    EXPECT_NEAR(slope(0.5), 1, 1e-15);
    EXPECT_NEAR(slope.value_on(0, 1, 0), 2, 1e-15);
    EXPECT_NEAR(slope(1), -1, 1e-15);
    EXPECT_NEAR(slope(1.75), -1, 1e-15);
    EXPECT_NEAR(integral(s, {0, 2}), 1.0 / 3 + 3.5, 1e-14);
}

}  // namespace spline_function_test
}  // namespace batten
