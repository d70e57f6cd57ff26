#include "num/gauss.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace batten::num {
namespace gauss_test {

TEST(GaussRules, HaveTheKnownNodes) {
    const GaussRule two = gauss_legendre(2);
    EXPECT_DOUBLE_EQ(two.nodes[1], 1 / std::sqrt(3.0));
    EXPECT_DOUBLE_EQ(two.weights[1], 1);
    const GaussRule five = gauss_legendre(5);
    EXPECT_EQ(five.nodes[2], 0);
    EXPECT_DOUBLE_EQ(five.nodes[4], std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3);
    EXPECT_DOUBLE_EQ(five.weights[4], (322 - 13 * std::sqrt(70.0)) / 900);
    // 20 digits of [DLMF, table 3.5.2].
    EXPECT_DOUBLE_EQ(gauss_legendre(10).nodes[9], 0.97390652851717172008);
    EXPECT_DOUBLE_EQ(gauss_legendre(10).weights[9], 0.06667134430868813759);
}

TEST(GaussRules, AreExactForAllDegreesTheyPromise) {
    for (int n = 1; n <= most_gauss_nodes; ++n) {
        const GaussRule rule = gauss_legendre(n);
        ASSERT_EQ(rule.nodes.size(), static_cast<std::size_t>(n));
        for (int power = 0; power<2 * n; power += n> 8 ? 7 : 1) {
            const double found =
                integrate([power](double x) { return std::pow(x, power); }, {-1, 1}, rule);
            const double exact = power % 2 == 0 ? 2.0 / (power + 1) : 0;
            EXPECT_NEAR(found, exact, 2e-15) << n << ' ' << power;
        }
    }
}

TEST(GaussRules, AreSymmetricToTheLastBit) {
    for (int n = 1; n <= most_gauss_nodes; ++n) {
        const GaussRule rule = gauss_legendre(n);
        for (std::size_t i = 0, j = rule.nodes.size() - 1; i < rule.nodes.size(); ++i, --j) {
            EXPECT_EQ(rule.nodes[i], -rule.nodes[j]);
            EXPECT_EQ(rule.weights[i], rule.weights[j]);
            if (i > 0) {
                EXPECT_LT(rule.nodes[i - 1], rule.nodes[i]);
            }
        }
    }
}

TEST(GaussRules, IntegrateOverAnyInterval) {
    const GaussRule rule = gauss_legendre(16);
    const double found = integrate([](double x) { return std::exp(x); }, {1, 3}, rule);
    EXPECT_NEAR(found, std::exp(3.0) - std::exp(1.0), 1e-14);
}

}  // namespace gauss_test
}  // namespace batten::num
