#include "fit_samples.hpp"

/// Intervals without data: what is determined and what is not.
namespace batten {
namespace fit_rank_test {

using testing::FitTable;

/// 20 intervals of length 5; nothing in `gap` intervals from the seventh on.
FitTable with_gap(int gap) {
    const FitTable all = testing::noisy_curve(401, 1, 21);
    FitTable table;
    for (std::size_t i = 0; i < all.x.size(); ++i) {
        const bool is_inside = all.x[i] > 30 && all.x[i] < 30 + 5 * gap;
        const bool is_edge = all.x[i] == 30.0 || all.x[i] == 30.0 + 5 * gap;
        if (is_inside || is_edge) continue;
        table.x.push_back(all.x[i]);
        table.y.push_back(all.y[i]);
        table.sigma.push_back(1);
    }
    return table;
}

TEST(FitWithEmptyIntervals, HasTheRankOfSchoenbergAndWhitney) {
    for (const int degree : {1, 3, 5}) {
        const int order = degree + 1;
        for (int gap = 1; gap <= order + 2; ++gap) {
            FitOptions options;
            options.degree = degree;
            options.knots = KnotPlacement::equal;
            options.intervals = 20;
            const Fit result = fit(with_gap(gap).view(), options);
            const int missing = std::max(0, gap - order + 1);
            EXPECT_EQ(result.report.parameters, 20 + degree);
            EXPECT_EQ(result.report.rank, 20 + degree - missing) << degree << " " << gap;
            EXPECT_EQ(static_cast<int>(result.report.undetermined.size()), missing);
            // Function j lives on intervals j - degree ... j: those inside the gap are open.
            for (int i = 0; i < missing; ++i) {
                EXPECT_EQ(result.report.undetermined[static_cast<std::size_t>(i)], 6 + degree + i);
            }
            EXPECT_EQ(result.report.status,
                      missing > 0 ? Status::rank_deficient : Status::met);
        }
    }
}

TEST(FitWithEmptyIntervals, FillsTheGapSmoothlyAndLeavesTheRestAlone) {
    // A polynomial of degree 3 has no fourth differences: the gap must continue it.
    FitTable table = with_gap(8);
    const auto cubic = [](double x) { return 1 + x * (0.5 + x * (-0.02 + 1e-4 * x)); };
    for (std::size_t i = 0; i < table.x.size(); ++i) table.y[i] = cubic(table.x[i]);
    FitOptions options;
    options.knots = KnotPlacement::equal;
    options.intervals = 20;
    const Fit result = fit(table.view(), options);
    ASSERT_EQ(result.report.rank, 18);
    for (double x = 10; x <= 90; x += 0.5) EXPECT_NEAR(result.spline(x), cubic(x), 1e-5) << x;
    for (const double x : {20.0, 25.0, 80.0, 90.0}) {
        EXPECT_NEAR(result.spline(x), cubic(x), 1e-11);
    }
}

TEST(FitByInsertion, DoesNotSplitWhatTheDataCannotFill) {
    const FitTable table = with_gap(10);
    const Fit result = fit(table.view(), {});
    EXPECT_EQ(result.report.rank, result.report.parameters);
    EXPECT_TRUE(result.report.undetermined.empty());
}

TEST(FitWithEmptyIntervals, SaysWhyThereIsNoBand) {
    FitOptions options;
    options.knots = KnotPlacement::equal;
    options.intervals = 20;
    const FitReport report = fit(with_gap(8).view(), options).report;
    EXPECT_TRUE(report.covariance_band.x.empty());
    ASSERT_EQ(report.notes.size(), 1u);
    EXPECT_NE(report.notes[0].find("5 coefficients are not determined"), std::string::npos);
}

}  // namespace fit_rank_test
}  // namespace batten
