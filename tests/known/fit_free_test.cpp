#include "fit_samples.hpp"
#include "shared_json.hpp"

/// Free knots against the best values known.
namespace batten {
namespace fit_free_test {

using testing::fit_table;

Fit free_fit(const testing::FitTable& table, int intervals) {
    FitOptions options;
    options.knots = KnotPlacement::free;
    options.intervals = intervals;
    return fit(table.view(), options);
}

TEST(FreeKnots, ReachTheBestKnownTitaniumFits) {
    SKIP_UNLESS_SHARED("reference/fitting/titanium_reference.json");
    const auto best =
        testing::shared_json("reference/fitting/titanium_reference.json")["free_knots_best_known"];
    const auto table = fit_table("titanium");
    for (const auto& row : best) {
        const int m = row["interior"];
        if (m > 8) break;
        const Fit result = free_fit(table, m + 1);
        const double allowed = m == 8 ? 1e-3 : 1e-6;
        EXPECT_LE(result.report.delta2, row["delta2"].get<double>() * (1 + allowed)) << m;
        EXPECT_EQ(result.report.parameters, m + 4);
        EXPECT_EQ(result.report.parameters_charged, 2 * m + 4);
        const bool is_unique = m != 3 && m < 8;
        const double close = m == 1 || m == 4 || m == 5 ? 1e-4 : 1e-3;
        for (int j = 0; is_unique && j < m; ++j) {
            EXPECT_NEAR(result.report.knots[4 + j], row["knots"][j].get<double>(), close)
                << m << " " << j;
        }
        const std::vector<std::string>& notes = result.report.notes;
        const auto tells = [&](const char* what) {
            return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) {
                return note.starts_with(what);
            });
        };
        EXPECT_TRUE(m == 8 || tells("knots: not unique") == (m == 3)) << m;
        EXPECT_EQ(tells("extrema: "), m > 0) << m;
    }
}

TEST(FreeKnots, CountEveryKnotOnTheWayAsInTheEnd) {
    SKIP_UNLESS_SHARED("reference/fitting/titanium.csv");
    const FitReport report = free_fit(fit_table("titanium"), 8).report;
    ASSERT_EQ(report.path.size(), 8u);
    for (int n = 1; n <= 8; ++n) EXPECT_EQ(report.path[static_cast<std::size_t>(n) - 1].intervals, n);
    EXPECT_EQ(report.intervals, 8);
}

TEST(FreeKnots, ReachTheReferenceOfTheSyntheticCurve) {
    SKIP_UNLESS_SHARED("reference/fitting/curve_freeknot_reference.json");
    const auto rows =
        testing::shared_json("reference/fitting/curve_freeknot_reference.json")["free_knots"];
    const auto table = fit_table("curve_equal");
    for (const auto& row : rows) {
        const Fit result = free_fit(table, row["n"]);
        EXPECT_LE(result.report.delta2, row["delta2"].get<double>() * 1.001) << row["n"];
    }
}

TEST(FreeKnots, FromPartWayNeedFewerKnotsThanInsertion) {
    SKIP_UNLESS_SHARED("reference/fitting/curve_equal.csv");
    FitOptions options;
    options.stop = StopRule::distribution;
    options.distribution = {0.68, 0.95, 0.99};
    options.knots = KnotPlacement::free;
    options.free_from = 2000;
    const Fit result = fit(fit_table("curve_equal").view(), options);
    EXPECT_EQ(result.report.status, Status::met);
    // The paper's run from insertion came to 15 intervals instead of 20.
    EXPECT_LE(result.report.intervals, 15);
    EXPECT_GT(result.report.parameters_charged, result.report.parameters);
}

TEST(FitToATolerance, TakesNoMoreCoefficientsThanFreeKnotsNeed) {
    SKIP_UNLESS_SHARED("data/titanium.csv");
    const auto table = fit_table("titanium");
    for (const int intervals : {4, 6}) {
        const FitReport freely = free_fit(table, intervals).report;
        FitOptions options;
        options.tolerance = absolute(*freely.max_residual * (1 + 1e-12));
        const FitReport report = fit(table.view(), options).report;
        EXPECT_EQ(report.status, Status::met);
        EXPECT_LE(report.parameters, freely.parameters) << intervals;
        EXPECT_LE(*report.max_residual, options.tolerance->value);
    }
}

}  // namespace fit_free_test
}  // namespace batten
