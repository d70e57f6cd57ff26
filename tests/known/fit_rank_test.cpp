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

/// The samples of a table from `first` on, before `last`.
FitTable part_of(const FitTable& table, double first, double last) {
    FitTable part;
    for (std::size_t i = 0; i < table.x.size(); ++i) {
        if (table.x[i] < first || table.x[i] >= last) continue;
        part.x.push_back(table.x[i]);
        part.y.push_back(table.y[i]);
        part.sigma.push_back(table.sigma[i]);
    }
    return part;
}

FitOptions over_knots(int degree, double first, double last) {
    FitOptions options;
    options.degree = degree;
    options.knots = KnotPlacement::given;
    for (double t = first; t <= last; t += 5) options.knots_values.push_back(t);
    return options;
}

TEST(FitWithEmptyIntervals, IsTheBestOnBothSidesHoweverUnevenTheErrors) {
    // Beyond a gap as wide as a B-spline the two sides know nothing of each other.
    for (const double error : {1.0, 1e-4, 1e-8}) {
        FitTable table = with_gap(8);
        table.sigma[40] = error;
        const double sides = fit(part_of(table, 0, 50).view(), over_knots(3, 5, 25)).report.delta2 +
                             fit(part_of(table, 50, 101).view(), over_knots(3, 75, 95)).report.delta2;
        FitOptions options;
        options.knots = KnotPlacement::equal;
        options.intervals = 20;
        const FitReport report = fit(table.view(), options).report;
        EXPECT_EQ(report.status, Status::rank_deficient);
        EXPECT_NEAR(report.delta2 / sides, 1, 1e-6) << error;
    }
}

/// The sum of squared differences round a ring.
double roughness(std::span<const double> c, std::size_t functions, int order) {
    double sum = 0;
    for (std::size_t j = 0; j < functions; ++j) {
        double difference = 0, choose = 1;
        for (int i = 0; i <= order; ++i) {
            difference += (i % 2 ? -choose : choose) *
                          c[(j + static_cast<std::size_t>(i)) % functions];
            choose = choose * (order - i) / (i + 1);
        }
        sum += difference * difference;
    }
    return sum;
}

TEST(ClosedFitWithEmptyIntervals, IsTheBestAndContinuesSmoothly) {
    for (const int degree : {1, 2, 3, 5}) {
        FitTable table = with_gap(8);
        table.y.back() = table.y.front();
        FitOptions options;
        options.degree = degree;
        options.closed = true;
        options.knots = KnotPlacement::equal;
        options.intervals = 20;
        const FitReport report = fit(table.view(), options).report;
        EXPECT_EQ(report.status, Status::rank_deficient);
        const int missing = 8 - degree;
        EXPECT_EQ(report.rank, 20 - missing);
        ASSERT_EQ(static_cast<int>(report.undetermined.size()), missing);
        EXPECT_EQ(report.undetermined.front(), 6 + degree);

        // The same spline cut open in the gap, where it is determined.
        FitTable cut = table;
        for (double& x : cut.x) x += x < 50 ? 100 : 0;
        const FitReport open = fit(cut.view(), over_knots(degree, 75, 125)).report;
        ASSERT_EQ(open.status, Status::met);
        EXPECT_NEAR(report.delta2 / open.delta2, 1, 1e-9) << degree;

        const double least = roughness(report.coefficients, 20, degree + 1);
        for (const int j : report.undetermined) {
            for (const double step : {-1e-2, 1e-2}) {
                std::vector<double> moved = report.coefficients;
                moved[static_cast<std::size_t>(j)] += step;
                EXPECT_GE(roughness(moved, 20, degree + 1), least) << degree << " " << j;
            }
        }
    }
}

TEST(ClosedFit, KnowsARingThatIsSingularThoughEveryFunctionHasASample) {
    // Straight stretches, a sample in the middle of each: 1, -1, 1, ... is not seen.
    FitTable table{{0.0}, {0.0}, {std::numeric_limits<double>::infinity()}};
    for (int i = 0; i < 8; ++i) {
        table.x.push_back(i + 0.5);
        table.y.push_back(i % 2 ? 9 : 11);
        table.sigma.push_back(1);
    }
    table.x.push_back(8);
    table.y.push_back(0);
    table.sigma.push_back(std::numeric_limits<double>::infinity());
    FitOptions options;
    options.degree = 1;
    options.closed = true;
    options.knots = KnotPlacement::equal;
    options.intervals = 8;
    const FitReport report = fit(table.view(), options).report;
    EXPECT_EQ(report.status, Status::rank_deficient);
    EXPECT_EQ(report.rank, 7);
    EXPECT_EQ(report.undetermined.size(), 8u);
    EXPECT_NEAR(report.delta2, 8, 1e-9);
    for (const double c : report.coefficients) EXPECT_NEAR(c, 10, 1e-6);
}

TEST(ClosedFitByInsertion, DoesNotSplitWhatTheDataCannotFill) {
    for (const int degree : {1, 3}) {
        FitOptions options;
        options.degree = degree;
        options.closed = true;
        options.stop = StopRule::gcv;
        const Fit result = fit(with_gap(10).view(), options);
        EXPECT_EQ(result.report.rank, result.report.parameters);
        EXPECT_TRUE(result.report.undetermined.empty());
    }
}

TEST(FreeKnots, OfFewerAbscissaeThanCoefficientsLeaveThemOpen) {
    FitTable table{{0, 0, 1, 1, 2, 2}, {1, 1.2, 3, 3.2, 2, 2.2}, {}};
    table.sigma.assign(6, 0.1);
    FitOptions options;
    for (const KnotPlacement knots : {KnotPlacement::automatic, KnotPlacement::free}) {
        options.knots = knots;
        const FitReport report = fit(table.view(), options).report;
        EXPECT_EQ(report.status, Status::rank_deficient);
        EXPECT_EQ(report.rank, 3);
        EXPECT_NEAR(report.delta2, 6, 1e-9);
        ASSERT_FALSE(report.path.empty());
        for (const FitStep& step : report.path) EXPECT_NEAR(step.delta2, 6, 1e-9);
    }
}

}  // namespace fit_rank_test
}  // namespace batten
