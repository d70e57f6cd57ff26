#include "num/nonnegative.hpp"
#include "num/symmetric.hpp"
#include "random.hpp"

#include <gtest/gtest.h>

#include <cmath>

/// Small dense problems: what the solutions must fulfil.
namespace batten::num {
namespace dense_law_test {

/// G^T G + shift: symmetric, its eigenvalues at least `shift`.
SymmetricMatrix random_matrix(testing::Random& random, std::size_t n, double shift) {
    std::vector<double> g(n * n);
    for (double& x : g) x = random.within(-1, 1);
    SymmetricMatrix m(n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            for (std::size_t l = 0; l < n; ++l) m(i, j) += g[l * n + i] * g[l * n + j];
        }
        m(i, i) += shift;
    }
    return m;
}

TEST(SolvePositive, GivesWhatTheMatrixTakesToTheRightSide) {
    testing::Random random(1);
    for (std::size_t n = 1; n <= 12; ++n) {
        const SymmetricMatrix m = random_matrix(random, n, 0.1);
        std::vector<double> right(n);
        for (double& x : right) x = random.within(-1, 1);
        const auto x = solve_positive(m, right);
        ASSERT_TRUE(x.has_value());
        const std::vector<double> back = product(m, *x);
        for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(back[i], right[i], 1e-12 * static_cast<double>(n));
    }
}

TEST(SolvePositive, RefusesWhatIsNotPositiveDefinite) {
    SymmetricMatrix m(2);
    m(0, 0) = 1;
    m(0, 1) = m(1, 0) = 2;
    m(1, 1) = 1;
    EXPECT_FALSE(solve_positive(m, std::vector<double>{1, 1}).has_value());
    EXPECT_FALSE(solve_positive(SymmetricMatrix(1), std::vector<double>{1}).has_value());
}

TEST(LeastEigenvalue, IsThatOfKnownMatrices) {
    SymmetricMatrix diagonal(3);
    diagonal(0, 0) = 3;
    diagonal(1, 1) = -2;
    diagonal(2, 2) = 7;
    EXPECT_EQ(least_eigenvalue(diagonal), -2);
    // The second difference of n points: 2 - 2 cos(pi / (n + 1)).
    for (std::size_t n = 2; n <= 20; ++n) {
        SymmetricMatrix m(n);
        for (std::size_t i = 0; i < n; ++i) {
            m(i, i) = 2;
            if (i > 0) m(i, i - 1) = m(i - 1, i) = -1;
        }
        const double s = std::sin(0.5 * 3.14159265358979323846 / static_cast<double>(n + 1));
        EXPECT_NEAR(least_eigenvalue(m), 4 * s * s, 1e-14 * static_cast<double>(n));
    }
}

TEST(NonnegativeLeastSquares, FulfilsTheConditionsOfKuhnAndTucker) {
    testing::Random random(2);
    for (int round = 0; round < 200; ++round) {
        const std::size_t rows = 2 + static_cast<std::size_t>(round) % 12;
        const std::size_t columns = 1 + static_cast<std::size_t>(round) % 9;
        DenseMatrix a(rows, columns);
        std::vector<double> right(rows);
        for (double& x : a.entries) x = random.within(-1, 1);
        for (double& x : right) x = random.within(-1, 1);
        const std::vector<double> x = nonnegative_least_squares(a, right);
        for (std::size_t j = 0; j < columns; ++j) {
            double slope = 0;
            for (std::size_t i = 0; i < rows; ++i) {
                double rest = right[i];
                for (std::size_t l = 0; l < columns; ++l) rest -= a(i, l) * x[l];
                slope += a(i, j) * rest;
            }
            EXPECT_GE(x[j], 0);
            EXPECT_LE(slope, 1e-10);
            if (x[j] > 0) {
                EXPECT_NEAR(slope, 0, 1e-8) << round << " " << j;
            }
        }
    }
}

TEST(LeastDistance, IsTheNearestPointOfAPolyhedron) {
    // x + y >= 2: (1, 1).
    DenseMatrix g(1, 2);
    g(0, 0) = g(0, 1) = 1;
    const auto half = least_distance(g, std::vector<double>{2});
    ASSERT_TRUE(half.has_value());
    EXPECT_NEAR(half->point[0], 1, 1e-14);
    EXPECT_NEAR(half->point[1], 1, 1e-14);
    EXPECT_EQ(half->active, std::vector<std::size_t>{0});
    // x >= 3 and y >= -1: (3, 0), and only the first pushes.
    DenseMatrix box(2, 2);
    box(0, 0) = box(1, 1) = 1;
    const auto corner = least_distance(box, std::vector<double>{3, -1});
    ASSERT_TRUE(corner.has_value());
    EXPECT_NEAR(corner->point[0], 3, 1e-14);
    EXPECT_NEAR(corner->point[1], 0, 1e-14);
    EXPECT_EQ(corner->active, std::vector<std::size_t>{0});
}

TEST(LeastDistance, SaysWhereThereIsNone) {
    DenseMatrix g(2, 1);
    g(0, 0) = 1;
    g(1, 0) = -1;
    EXPECT_FALSE(least_distance(g, std::vector<double>{1, 1}).has_value());
    EXPECT_TRUE(least_distance(g, std::vector<double>{1, -2}).has_value());
}

TEST(LeastDistance, SaysSoHoweverLittleTheRowsContradictEachOther) {
    testing::Random random(7);
    for (int round = 0; round < 50; ++round) {
        const std::size_t n = 2 + static_cast<std::size_t>(round) % 10;
        DenseMatrix g(n + 1, n);
        std::vector<double> right(n + 1, 0.0);
        for (std::size_t j = 0; j < n; ++j) {
            g(j, j) = 1;
            g(n, j) = -1;
            right[j] = random.within(1, 1000);
            right[n] -= right[j];
        }
        const double sum = right[n];
        for (const double gap : {1.0, 1e-3, 1e-5}) {
            right[n] = sum + gap;
            EXPECT_FALSE(least_distance(g, right).has_value()) << round << " " << gap;
            right[n] = sum - gap;
            EXPECT_TRUE(least_distance(g, right).has_value()) << round << " " << gap;
        }
    }
}

}  // namespace dense_law_test
}  // namespace batten::num
