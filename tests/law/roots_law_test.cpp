#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "num/roots.hpp"
#include "random.hpp"

namespace batten::num {
namespace roots_law_test {

using testing::Random;

TEST(RealRoots, OfRandomCubicsAreThoseTheyWereMadeFrom) {
    Random random(1);
    for (int k = 0; k < 20000; ++k) {
        double e[] = {random.within(-1, 1) * std::exp(random.within(-4, 4)), random.within(-1, 1),
                      random.within(-1, 1) * std::exp(random.within(-7, 7))};
        std::sort(e, e + 3);
        const double lead = random.within(0.1, 2);
        const long double a = lead, x = e[0], y = e[1], z = e[2];
        const RealRoots roots = real_roots(std::array<double, 4>{
            static_cast<double>(-a * x * y * z), static_cast<double>(a * (x * y + x * z + y * z)),
            static_cast<double>(-a * (x + y + z)), lead});
        // A root moves by about (rounding of the coefficients) / (distance to its neighbours).
        const double largest = std::max(std::fabs(e[0]), std::fabs(e[2]));
        const double gap = std::min(e[1] - e[0], e[2] - e[1]) / largest;
        if (gap < 1e-6) continue;
        ASSERT_EQ(roots.count, 3);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(roots[i], e[i], 1e-14 * largest / gap);
    }
}

TEST(Roots, AreTheSameForCoefficientsTimesAPowerOfTwo) {
    Random random(2);
    for (int k = 0; k < 2000; ++k) {
        std::array<double, 4> cubic{};
        for (double& c : cubic) c = random.within(-1, 1);
        std::array<double, 4> scaled = cubic;
        for (double& c : scaled) c = std::ldexp(c, k % 400 - 200);
        const RealRoots a = real_roots(cubic), b = real_roots(scaled);
        ASSERT_EQ(a.count, b.count);
        for (int i = 0; i < a.count; ++i) EXPECT_EQ(a[i], b[i]);
        const std::array<std::complex<double>, 3> c{
            {{cubic[0], cubic[1]}, {cubic[2], cubic[3]}, {cubic[1], -cubic[2]}}};
        const std::array<std::complex<double>, 3> d{
            {{scaled[0], scaled[1]}, {scaled[2], scaled[3]}, {scaled[1], -scaled[2]}}};
        const ComplexRoots p = complex_roots(c), q = complex_roots(d);
        ASSERT_EQ(p.count, 2);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(p.values[i], q.values[i]);
            const auto value = c[0] + p.values[i] * (c[1] + p.values[i] * c[2]);
            const double size = std::abs(p.values[i]) + 1;
            EXPECT_LT(std::abs(value), 1e-14 * size * size);
        }
    }
}

}  // namespace roots_law_test
}  // namespace batten::num
