#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "num/banded_qr.hpp"
#include "random.hpp"

/// The loops for four neighbours a row, beside those for any band.
namespace batten::num {
namespace cubic_band_law_test {

constexpr BandShape cubic(int columns) { return {4, columns, 0, 1}; }

/// Blocks of 4 rows; their columns' scales differ by up to 2^40.
struct Problem {
    int columns = 0;
    std::vector<int> firsts;
    std::vector<double> blocks;
};

Problem random_problem(testing::Random& random, bool has_gap) {
    Problem p;
    const int intervals = random.whole(has_gap ? 3 : 1, 30);
    int first = 0;
    for (int i = 0; i < intervals; ++i) {
        p.firsts.push_back(first);
        for (int j = 0; j < 20; ++j) {
            const double scale = j % 5 == 4 ? 1 : std::ldexp(1, (first + j % 5) % 5 * 10 - 20);
            p.blocks.push_back(random.within(-1, 1) * scale);
        }
        first += has_gap && i == 1 ? 2 : 1;
    }
    p.columns = p.firsts.back() + 4;
    return p;
}

BandedQr absorbed(const Problem& p) {
    BandedQr qr(cubic(p.columns));
    for (std::size_t i = 0; i < p.firsts.size(); ++i) {
        std::vector<double> block(p.blocks.begin() + static_cast<std::ptrdiff_t>(20 * i),
                                  p.blocks.begin() + static_cast<std::ptrdiff_t>(20 * i + 20));
        qr.absorb(p.firsts[i], block.data(), 4);
    }
    qr.finish();
    return qr;
}

TEST(CubicBand, IsReducedAsAnyOtherBand) {
    testing::Random random(1);
    for (int round = 0; round < 200; ++round) {
        const Problem p = random_problem(random, round % 2 == 1);
        BandedQr qr(cubic(p.columns));
        qr.reduce(p.firsts, p.blocks);
        const BandedQr other = absorbed(p);
        for (int j = 0; j < p.columns; ++j) {
            for (int l = 0; l < 5; ++l) {
                // Relative to the column, or to the side.
                double norm = 1e-300;
                for (int i = std::max(0, j - 3); i < p.columns && l < 4; ++i) {
                    const int at = j + l - i;
                    if (at >= 0 && at < 4) norm += std::fabs(other.row(i)[at]);
                }
                for (int i = 0; i < p.columns && l == 4; ++i) norm += std::fabs(other.row(i)[4]);
                EXPECT_NEAR(qr.row(j)[l] / norm, other.row(j)[l] / norm, 1e-11) << j << " " << l;
            }
        }
        const double rest = other.residual_products()[0];
        EXPECT_NEAR(qr.residual_products()[0], rest, 1e-12 * (1 + rest));
    }
}

TEST(CubicBand, IsSolvedRowByRow) {
    testing::Random random(2);
    for (int round = 0; round < 100; ++round) {
        const Problem p = random_problem(random, false);
        const BandedQr qr = absorbed(p);
        std::vector<double> c(static_cast<std::size_t>(p.columns));
        qr.solve(0, c);
        for (int j = 0; j < p.columns; ++j) {
            double sum = 0, size = std::fabs(qr.row(j)[4]);
            for (int l = 0; l < 4 && j + l < p.columns; ++l) {
                const double term = qr.row(j)[l] * c[static_cast<std::size_t>(j + l)];
                sum += term;
                size += std::fabs(term);
            }
            EXPECT_NEAR(sum / size, qr.row(j)[4] / size, 1e-14);
        }
    }
}

TEST(CubicBand, LeavesAnUnknownWithoutAPivotAtZero) {
    const std::vector<double> blocks{1, 0, 0, 0, 1, 0, 1, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 1, 4};
    BandedQr qr(cubic(4));
    qr.reduce(std::vector<int>{0}, blocks);
    std::vector<double> c(4);
    qr.solve(0, c);
    EXPECT_EQ(c, (std::vector<double>{1, 2, 0, 4}));
    EXPECT_EQ(qr.inverse_band(4)[8], 0);
}

TEST(CubicBand, HasTheInverseOfItsNormalMatrix) {
    testing::Random random(3);
    for (int round = 0; round < 100; ++round) {
        const Problem p = random_problem(random, false);
        const BandedQr qr = absorbed(p);
        const int n = p.columns;
        const auto normal = [&](int i, int j) {
            double sum = 0;
            for (int r = std::max(0, std::max(i, j) - 3); r <= std::min(i, j); ++r) {
                sum += qr.row(r)[i - r] * qr.row(r)[j - r];
            }
            return sum;
        };
        for (const int reach : {4, 5}) {
            const std::vector<double> z = qr.inverse_band(reach);
            ASSERT_EQ(z.size(), static_cast<std::size_t>(n * reach));
            // Every entry of the product that needs no more of the inverse than is known.
            for (int i = 0; i < n; ++i) {
                for (int j = i; j < std::min(n, i + reach - 3); ++j) {
                    double sum = 0, size = 0;
                    for (int k = std::max(0, i - 3); k < std::min(n, i + 4); ++k) {
                        const int row = std::min(k, j), off = std::abs(k - j);
                        const double term =
                            normal(i, k) * z[static_cast<std::size_t>(row * reach + off)];
                        sum += term;
                        size += std::fabs(term);
                    }
                    EXPECT_NEAR(sum, i == j ? 1 : 0, 1e-10 * (1 + size)) << i << " " << j;
                }
            }
        }
    }
}

}  // namespace cubic_band_law_test
}  // namespace batten::num
