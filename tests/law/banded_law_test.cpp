#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "num/banded.hpp"
#include "random.hpp"

namespace batten::num {
namespace banded_law_test {

using Columns = std::vector<std::vector<double>>;

std::vector<TridiagonalRow> dominated_rows(testing::Random& random, std::size_t n) {
    std::vector<TridiagonalRow> rows(n);
    for (TridiagonalRow& row : rows) {
        row.lower = random.within(-1, 1);
        row.upper = random.within(-1, 1);
        const double least = std::fabs(row.lower) + std::fabs(row.upper);
        row.diagonal = (least + random.within(0.01, 2)) * (random.whole(0, 1) == 0 ? 1 : -1);
    }
    return rows;
}

Columns random_columns(testing::Random& random, std::size_t n, int count) {
    Columns columns(static_cast<std::size_t>(count), std::vector<double>(n));
    for (auto& column : columns) {
        for (double& x : column) x = random.within(-1, 1);
    }
    return columns;
}

template <class Solve>
Columns solved(const std::vector<TridiagonalRow>& rows, Columns columns, Solve&& solve) {
    std::vector<double*> starts;
    for (auto& column : columns) starts.push_back(column.data());
    std::vector<double> work(rows.size());
    solve(
        rows.size(), [&](std::size_t i) { return rows[i]; }, starts, work);
    return columns;
}

Columns solved_open(const std::vector<TridiagonalRow>& rows, const Columns& columns) {
    return solved(rows, columns, [](std::size_t n, auto row, auto& x, auto& work) {
        solve_tridiagonal(n, row, x, work);
    });
}

Columns solved_cyclic(const std::vector<TridiagonalRow>& rows, const Columns& columns) {
    return solved(rows, columns, [](std::size_t n, auto row, auto& x, auto& work) {
        solve_cyclic(n, row, x, work);
    });
}

/// The largest |matrix x - column|, the matrix being cyclic.
double residual(const std::vector<TridiagonalRow>& rows, const Columns& x, const Columns& columns) {
    const std::size_t n = rows.size();
    double largest = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            const double sum = rows[i].lower * x[k][(i + n - 1) % n] + rows[i].diagonal * x[k][i] +
                               rows[i].upper * x[k][(i + 1) % n];
            largest = std::max(largest, std::fabs(sum - columns[k][i]));
        }
    }
    return largest;
}

TEST(SolveTridiagonal, SatisfiesItsEquations) {
    testing::Random random(31);
    for (std::size_t n = 1; n < 40; ++n) {
        std::vector<TridiagonalRow> rows = dominated_rows(random, n);
        rows.front().lower = rows.back().upper = 0;
        const Columns columns = random_columns(random, n, random.whole(1, 9));
        ASSERT_LE(residual(rows, solved_open(rows, columns), columns), 4e-15) << n;
    }
}

TEST(SolveCyclic, SatisfiesItsEquations) {
    testing::Random random(32);
    for (std::size_t n = 3; n < 40; ++n) {
        const std::vector<TridiagonalRow> rows = dominated_rows(random, n);
        const Columns columns = random_columns(random, n, random.whole(1, 9));
        ASSERT_LE(residual(rows, solved_cyclic(rows, columns), columns), 3e-14) << n;
    }
}

TEST(SolveTridiagonal, OfOddSizeIsTheSameFromBothEnds) {
    testing::Random random(33);
    for (std::size_t n = 1; n < 30; n += 2) {
        std::vector<TridiagonalRow> rows = dominated_rows(random, n), backwards;
        rows.front().lower = rows.back().upper = 0;
        Columns columns = random_columns(random, n, 3);
        const Columns forwards = solved_open(rows, columns);
        for (std::size_t i = n; i-- > 0;) {
            backwards.push_back({rows[i].upper, rows[i].diagonal, rows[i].lower});
        }
        for (auto& column : columns) std::reverse(column.begin(), column.end());
        Columns result = solved_open(backwards, columns);
        for (auto& column : result) std::reverse(column.begin(), column.end());
        ASSERT_EQ(result, forwards) << n;
    }
}

TEST(SolveTridiagonal, DoesNotDependOnTheOtherColumns) {
    testing::Random random(34);
    std::vector<TridiagonalRow> rows = dominated_rows(random, 12);
    rows.front().lower = rows.back().upper = 0;
    const Columns columns = random_columns(random, 12, 7);
    const Columns together = solved_open(rows, columns);
    for (std::size_t k = 0; k < columns.size(); ++k) {
        ASSERT_EQ(solved_open(rows, {columns[k]})[0], together[k]);
    }
}

}  // namespace banded_law_test
}  // namespace batten::num
