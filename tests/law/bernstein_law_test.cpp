#include <gtest/gtest.h>

#include <cmath>

#include "num/bernstein.hpp"
#include "num/chebyshev.hpp"
#include "num/sum.hpp"
#include "random.hpp"

namespace batten {
namespace bernstein_law_test {

using bernstein::Coefficients;
using testing::Random;

Coefficients from_roots(const std::vector<double>& roots) {
    Coefficients product(1);
    product[0] = 1;
    for (const double root : roots) {
        Coefficients factor(2);
        factor[0] = -root;
        factor[1] = 1 - root;
        product = bernstein::product(product, factor);
    }
    return product;
}

double direct(const std::vector<double>& roots, double u) {
    double product = 1;
    for (const double root : roots) product *= u - root;
    return product;
}

TEST(BernsteinForm, AgreesWithTheProductOfItsFactors) {
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        std::vector<double> roots;
        for (int j = random.whole(0, 40); j > 0; --j) roots.push_back(random.within(-1, 2));
        const Coefficients c = from_roots(roots);
        const double u = random.within(0, 1), at = random.within(0, 1);
        const double size = bernstein::bound(c);
        EXPECT_NEAR(bernstein::value(c, u), direct(roots, u), 1e-14 * size);
        const bernstein::Halves halves = bernstein::split(c, at);
        EXPECT_NEAR(bernstein::value(halves.left, u), direct(roots, u * at), 1e-13 * size);
        EXPECT_NEAR(bernstein::value(halves.right, u), direct(roots, at + u * (1 - at)),
                    1e-13 * size);
        EXPECT_NEAR(bernstein::value(bernstein::raised(c, c.size() + 2), u), direct(roots, u),
                    1e-13 * size);
    }
}

TEST(BernsteinForm, DerivativeIsTheSlope) {
    Random random(2);
    for (int degree = 0; degree < 9; ++degree) {
        Coefficients c(static_cast<std::size_t>(degree) + 1);
        for (double& x : c) x = random.within(-1, 1);
        const double h = 1e-6, u = random.within(0.1, 0.9);
        const double slope = (bernstein::value(c, u + h) - bernstein::value(c, u - h)) / (2 * h);
        EXPECT_NEAR(bernstein::value(bernstein::derivative(c), u), slope, 1e-8);
    }
}

TEST(BernsteinRoots, AreAllFoundAndNoOthers) {
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        std::vector<double> roots, inside;
        const int count = random.whole(1, 7);
        for (int j = 0; j < count; ++j) {
            // Apart by 1/20 or more, some outside.
            roots.push_back(-0.2 + 0.2 * j + random.within(0, 0.15));
            if (roots.back() >= 0 && roots.back() <= 1) inside.push_back(roots.back());
        }
        const Coefficients c = from_roots(roots);
        const std::vector<double> found = bernstein::roots(c, 0x1p-50 * bernstein::bound(c));
        ASSERT_EQ(found.size(), inside.size());
        for (std::size_t j = 0; j < found.size(); ++j) EXPECT_NEAR(found[j], inside[j], 1e-8);
    }
}

TEST(BernsteinRoots, AtTheEndsAreExact) {
    const std::vector<double> found = bernstein::roots(from_roots({0, 0.3, 1}), 1e-16);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0], 0);
    EXPECT_NEAR(found[1], 0.3, 1e-15);
    EXPECT_EQ(found[2], 1);
}

TEST(BernsteinRoots, TouchesAreListedOnceAndDoNotChangeTheSign) {
    for (const double touch : {0.5, 1.0 / 3, 0.123456789}) {
        const Coefficients c = from_roots({touch, touch, 2});
        const std::vector<double> found = bernstein::roots(c, 1e-16);
        ASSERT_EQ(found.size(), 1u) << touch;
        EXPECT_NEAR(found[0], touch, 1e-7);
        const auto runs = bernstein::sign_runs(c, 1e-16);
        ASSERT_EQ(runs.size(), 1u);
        EXPECT_EQ(runs[0].sign, -1);
        EXPECT_EQ(runs[0].where, (Interval{0, 1}));
    }
}

TEST(BernsteinRoots, OfNothingButNoiseAreNone) {
    Coefficients noise(4);
    noise[1] = 1e-17;
    noise[2] = -1e-17;
    EXPECT_TRUE(bernstein::roots(noise, 1e-16).empty());
    EXPECT_TRUE(bernstein::sign_runs(noise, 1e-16).empty());
}

TEST(ChebyshevBasis, KeepsThePolynomial) {
    Random random(4);
    for (std::size_t degree = 0; degree < 16; ++degree) {
        Coefficients b(degree + 1), c(degree + 1), left(degree + 1), right(degree + 1);
        for (double& x : b) x = random.within(-1, 1);
        const chebyshev::Basis basis(degree);
        basis.from_bernstein(b, c.data());
        basis.left_half(c, left.data());
        basis.right_half(c, right.data());
        for (const double x : {-1.0, -0.3, 0.0, 0.8, 1.0}) {
            const auto exact = [&](double y) { return bernstein::value(b, 0.5 + 0.5 * y); };
            EXPECT_NEAR(chebyshev::value(c, x), exact(x), 1e-14);
            EXPECT_NEAR(chebyshev::value(left, x), exact(0.5 * x - 0.5), 2e-14);
            EXPECT_NEAR(chebyshev::value(right, x), exact(0.5 * x + 0.5), 2e-14);
        }
    }
}

TEST(CompensatedSum, DoesNotLoseSmallTerms) {
    num::Sum sum;
    sum.add(1e16);
    for (int i = 0; i < 1000; ++i) sum.add(0.125);
    sum.add(-1e16);
    EXPECT_EQ(sum.value(), 125);
}

}  // namespace bernstein_law_test
}  // namespace batten
