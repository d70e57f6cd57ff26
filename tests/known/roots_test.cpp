#include "num/roots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace batten::num {
namespace roots_test {

using Line = std::array<double, 3>;
using Cubic = std::array<double, 4>;

TEST(RealRoots, OfQuadraticsAreRisingAndComplete) {
    const RealRoots two = real_roots(Line{1, -3, 2});
    ASSERT_EQ(two.count, 2);
    EXPECT_EQ(two[0], 0.5);
    EXPECT_EQ(two[1], 1);
    EXPECT_EQ(real_roots(Line{1, 2, 1}).count, 2);
    EXPECT_EQ(real_roots(Line{1, 1, 1}).count, 0);
    EXPECT_EQ(real_roots(Line{0, 0, 0}).count, 0);
    EXPECT_EQ(real_roots(Line{5, 0, 0}).count, 0);
    const RealRoots linear = real_roots(Line{3, -2, 0});
    ASSERT_EQ(linear.count, 1);
    EXPECT_EQ(linear[0], 1.5);
}

TEST(RealRoots, OfNearlyDoubleQuadraticsKeepTheirDigits) {
    // Kahan's example: the discriminant of the plain formula loses all digits.
    const RealRoots roots = real_roots(Line{94906268.375, -2 * 94906267.375, 94906266.375});
    ASSERT_EQ(roots.count, 2);
    EXPECT_DOUBLE_EQ(roots[0], 1);
    EXPECT_DOUBLE_EQ(roots[1], 1.000000021073424755);
}

TEST(RealRoots, OfLopsidedQuadraticsDoNotCancelOrOverflow) {
    const RealRoots roots = real_roots(Line{1, 1e10, 1});
    ASSERT_EQ(roots.count, 2);
    EXPECT_DOUBLE_EQ(roots[0], -1e10);
    EXPECT_DOUBLE_EQ(roots[1], -1e-10);
    const RealRoots huge = real_roots(Line{-2e300, 1e300, 1e300});
    ASSERT_EQ(huge.count, 2);
    EXPECT_DOUBLE_EQ(huge[0], -2);
    EXPECT_DOUBLE_EQ(huge[1], 1);
    EXPECT_EQ(real_roots(Line{1e200, 1e200, 1e-200}).count, 1);  // the other is beyond a double
}

TEST(RealRoots, OfCubicsAreRisingAndComplete) {
    const RealRoots three = real_roots(Cubic{-6, 11, -6, 1});
    ASSERT_EQ(three.count, 3);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(three[i], i + 1, 1e-14);
    const RealRoots one = real_roots(Cubic{-2, 0, 0, 1});
    ASSERT_EQ(one.count, 1);
    EXPECT_DOUBLE_EQ(one[0], std::cbrt(2.0));
    const RealRoots triple = real_roots(Cubic{-1, 3, -3, 1});
    ASSERT_EQ(triple.count, 3);
    for (double root : triple) EXPECT_EQ(root, 1);
    EXPECT_EQ(real_roots(Cubic{0, 0, 0, 4}).count, 3);
    EXPECT_EQ(real_roots(Cubic{1, -3, 2, 0}).count, 2);
    EXPECT_EQ(real_roots(Cubic{0, 0, 0, 0}).count, 0);
}

TEST(ComplexRoots, OfQuadraticsWithComplexCoefficients) {
    using C = std::complex<double>;
    const C p(1, 2), q(-0.5, 3), lead(2, -1);
    const ComplexRoots roots = complex_roots({lead * p * q, -lead * (p + q), lead});
    ASSERT_EQ(roots.count, 2);
    const bool is_p_first = std::abs(roots.values[0] - p) < 1;
    EXPECT_LT(std::abs(roots.values[is_p_first ? 0 : 1] - p), 1e-14);
    EXPECT_LT(std::abs(roots.values[is_p_first ? 1 : 0] - q), 1e-14);
    const ComplexRoots linear = complex_roots({C(1, 1), C(0, 1), C(0, 0)});
    ASSERT_EQ(linear.count, 1);
    EXPECT_EQ(linear.values[0], C(-1, 1));
    const ComplexRoots imaginary = complex_roots({C(1), C(0), C(1)});
    ASSERT_EQ(imaginary.count, 2);
    EXPECT_EQ(imaginary.values[0] + imaginary.values[1], C(0));
}

TEST(ScalarRoot, IsFoundToTheLastBits) {
    const ScalarPoint fixed = find_root([](double x) { return std::cos(x) - x; }, {0, 1});
    EXPECT_NEAR(fixed.at, 0.7390851332151606417, 2e-16);
    EXPECT_LT(fixed.evaluations, 12);
    const auto steep = [](double x) { return std::tanh(50 * (x - 0.3)); };
    EXPECT_NEAR(find_root(steep, {-10, 3}).at, 0.3, 1e-15);
    EXPECT_EQ(find_root([](double x) { return x; }, {0, 1}).at, 0);
    EXPECT_NEAR(find_root([](double x) { return x * x * x; }, {-1, 2.5}).at, 0, 1e-30);
}

TEST(ScalarRoot, StopsAtTheToleranceAskedFor) {
    const auto f = [](double x) { return std::exp(x) - 2; };
    for (const double tolerance : {1e-2, 1e-5, 1e-9}) {
        EXPECT_NEAR(find_root(f, {0, 5}, tolerance).at, std::numbers::ln2, tolerance);
    }
}

TEST(ScalarMinimum, IsFoundToTheRootOfThePrecision) {
    const ScalarPoint minimum = find_minimum([](double x) { return std::cos(x); }, {0, 5}, 1);
    EXPECT_NEAR(minimum.at, std::numbers::pi, 1e-7);
    EXPECT_EQ(minimum.value, -1);
    EXPECT_LT(minimum.evaluations, 25);
    const ScalarPoint kink = find_minimum([](double x) { return std::fabs(x - 0.3); }, {-9, 5}, 1);
    EXPECT_NEAR(kink.at, 0.3, 1e-7);
    const ScalarPoint end = find_minimum([](double x) { return x; }, {2, 4}, 3);
    EXPECT_NEAR(end.at, 2, 1e-6);
}

}  // namespace roots_test
}  // namespace batten::num
