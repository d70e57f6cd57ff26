#include "fit_samples.hpp"
#include "shared_json.hpp"

/// The reference fits, computed by dense QR in other hands.
namespace batten {
namespace fit_path_test {

using testing::fit_table;

FitOptions by_distribution() {
    FitOptions options;
    options.stop = StopRule::distribution;
    options.distribution = {0.68, 0.95, 0.99};
    return options;
}

void expect_coefficients(const FitReport& report, const nlohmann::json& reference) {
    ASSERT_EQ(report.coefficients.size(), reference.size());
    for (std::size_t j = 0; j < reference.size(); ++j) {
        const double c = reference[j];
        EXPECT_NEAR(report.coefficients[j], c, 1e-9 * std::max(1.0, std::fabs(c))) << j;
    }
}

void expect_path(const std::vector<FitStep>& path, const nlohmann::json& reference) {
    for (std::size_t i = 0; i < path.size() && i < reference.size(); ++i) {
        const auto& step = reference[i];
        EXPECT_EQ(path[i].intervals, step["n"].get<int>());
        EXPECT_NEAR(path[i].delta2 / step["delta2"].get<double>(), 1, 1e-9) << i;
        EXPECT_NEAR(*path[i].sigma2 / step["sigma2"].get<double>(), 1, 1e-9) << i;
        EXPECT_NEAR(path[i].aic / step["aic"].get<double>(), 1, 1e-9) << i;
        if (step.contains("psi")) {
            EXPECT_EQ(path[i].psi, step["psi"].get<std::vector<double>>()) << i;
        }
    }
}

TEST(FitOverEqualIntervals, GivesTheReference) {
    SKIP_UNLESS_SHARED("reference/fitting/curve_reference.json");
    const auto reference =
        testing::shared_json("reference/fitting/curve_reference.json")["equal"]["kprog1_n10"];
    const auto table = fit_table("curve_equal");
    FitOptions options;
    options.knots = KnotPlacement::equal;
    options.intervals = 10;
    const Fit result = fit(table.view(), options);
    EXPECT_NEAR(result.report.delta2 / reference["delta2"].get<double>(), 1, 1e-9);
    EXPECT_NEAR(*result.report.sigma2 / reference["sigma2"].get<double>(), 1, 1e-9);
    EXPECT_NEAR(result.report.aic / reference["aic"].get<double>(), 1, 1e-9);
    expect_coefficients(result.report, reference["coef"]);

    options.knots = KnotPlacement::given;
    options.intervals.reset();
    for (int i = 1; i < 10; ++i) options.knots_values.push_back(10 * i);
    EXPECT_EQ(fit(table.view(), options).report.coefficients, result.report.coefficients);
}

TEST(FitByInsertion, FollowsTheReferencePathAndStopsWhereThePaperDoes) {
    SKIP_UNLESS_SHARED("reference/fitting/curve_reference.json");
    const auto reference =
        testing::shared_json("reference/fitting/curve_reference.json")["equal"];
    const Fit result = fit(fit_table("curve_equal").view(), by_distribution());
    EXPECT_EQ(result.report.status, Status::met);
    EXPECT_EQ(result.report.intervals, 20);
    EXPECT_EQ(result.report.breaks,
              reference["kprog2"]["knots"].get<std::vector<double>>());
    EXPECT_EQ(result.report.psi, reference["kprog2"]["psi"].get<std::vector<double>>());
    EXPECT_NEAR(result.report.delta2 / reference["kprog2"]["delta2"].get<double>(), 1, 1e-9);
    expect_coefficients(result.report, reference["kprog2"]["coef"]);
    ASSERT_EQ(result.report.path.size(), reference["kprog2_history"].size());
    expect_path(result.report.path, reference["kprog2_history"]);
}

TEST(FitByInsertion, GoesOnPastTheFirstHit) {
    SKIP_UNLESS_SHARED("reference/fitting/curve_reference.json");
    const auto reference =
        testing::shared_json("reference/fitting/curve_reference.json")["equal"]["history_to_40"];
    const Fit result = fit(fit_table("curve_equal").view(), {});
    EXPECT_EQ(result.report.path.size(), 45u);
    expect_path(result.report.path, reference);
    EXPECT_EQ(result.report.intervals, 20);
}

TEST(FitByInsertion, FollowsTheTitaniumPath) {
    SKIP_UNLESS_SHARED("reference/fitting/titanium_reference.json");
    const auto history =
        testing::shared_json("reference/fitting/titanium_reference.json")["kprog2_history"];
    const auto table = fit_table("titanium");
    FitOptions options = by_distribution();
    const Fit stopped = fit(table.view(), options);
    EXPECT_EQ(stopped.report.intervals, 8);
    EXPECT_NEAR(stopped.report.delta2, 27.883080, 1e-6);
    EXPECT_NEAR(stopped.report.aic, 185.07298, 1e-5);

    options = {};
    options.intervals = static_cast<int>(history.size());
    const Fit whole = fit(table.view(), options);
    ASSERT_EQ(whole.report.path.size(), history.size());
    expect_path(whole.report.path, history);
    EXPECT_EQ(whole.report.breaks, history.back()["knots"].get<std::vector<double>>());
}

TEST(FitToADelta2, KeepsNoKnotThatCouldGo) {
    for (const std::size_t count : {201, 3000}) {
        const testing::FitTable table = testing::noisy_curve(count, 1.5, 6);
        FitOptions options;
        options.delta2 = static_cast<double>(count);
        const FitReport report = fit(table.view(), options).report;
        EXPECT_LE(report.delta2, *options.delta2);
        EXPECT_EQ(report.path.back().intervals, report.intervals);
        for (int i = 1; i < report.intervals; ++i) {
            FitOptions without;
            without.knots = KnotPlacement::given;
            without.knots_values = report.breaks;
            without.knots_values.erase(without.knots_values.begin() + i);
            EXPECT_GT(fit(table.view(), without).report.delta2, *options.delta2) << i;
        }
    }
}

TEST(FitToADelta2, EndsItsPathWithTheFitItReports) {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        // Twenty times as many samples in the left half.
        testing::FitTable table;
        testing::Noise noise(seed);
        for (int i = 0; i < 210; ++i) {
            table.x.push_back(i < 200 ? i / 400.0 : 0.5 + (i - 199) / 20.0);
            table.y.push_back(std::sin(40 / (table.x.back() + 0.5)) + 0.1 * noise.normal());
            table.sigma.push_back(0.1);
        }
        FitOptions options;
        options.delta2 = 210;
        const FitReport report = fit(table.view(), options).report;
        EXPECT_NEAR(report.path.back().delta2, report.delta2, 1e-9 * report.delta2) << seed;
        FitOptions again;
        again.knots = KnotPlacement::given;
        again.knots_values = report.breaks;
        EXPECT_NEAR(fit(table.view(), again).report.delta2, report.delta2, 1e-9 * report.delta2);
    }
}

TEST(FitToADelta2, NeedsAsFewKnotsForABumpAsAreSetByHand) {
    testing::FitTable table;
    testing::Noise noise(3);
    for (int i = 0; i < 10000; ++i) {
        const double x = i / 9999.0;
        table.x.push_back(x);
        table.y.push_back(std::exp(-50 * (x - 0.4) * (x - 0.4)) + 0.5 * std::sin(6 * x) +
                          0.1 * noise.normal());
        table.sigma.push_back(0.1);
    }
    FitOptions by_hand;
    by_hand.knots = KnotPlacement::given;
    by_hand.knots_values = {0.257, 0.386, 0.505, 0.621, 0.745};
    FitOptions options;
    options.delta2 = fit(table.view(), by_hand).report.delta2;
    const FitReport report = fit(table.view(), options).report;
    EXPECT_LE(report.delta2, *options.delta2);
    EXPECT_LE(report.breaks.size(), 2 + by_hand.knots_values.size());
}

TEST(FitOverFixedKnots, IsThatOfSortedSamplesAndLeavesOutWhatHasNoWeight) {
    testing::FitTable table = testing::noisy_curve(5000, 1.5, 8);
    FitOptions options;
    options.knots = KnotPlacement::equal;
    options.intervals = 20;
    const FitReport sorted = fit(table.view(), options).report;
    for (auto* column : {&table.x, &table.y, &table.sigma}) {
        std::reverse(column->begin() + 1000, column->begin() + 3000);
    }
    EXPECT_EQ(fit(table.view(), options).report.coefficients, sorted.coefficients);
    table.y[4000] = 1e9;
    table.sigma[4000] = std::numeric_limits<double>::infinity();
    const FitReport one_less = fit(table.view(), options).report;
    EXPECT_EQ(one_less.samples, 4999u);
    EXPECT_NEAR(one_less.delta2, sorted.delta2, 30);
}

TEST(FitByInsertion, TellsOfIntervalsThatFitEquallyBadly) {
    testing::FitTable table;
    // None in the middle: a sample on a knot counts on its right.
    for (int i = 0; i < 40; ++i) {
        table.x.push_back((2 * i - 39) / 39.0);
        table.y.push_back(std::exp(-8 * table.x.back() * table.x.back()));
    }
    FitOptions options;
    options.sigma = 0.2;
    options.intervals = 3;
    const FitReport report = fit(table.without_sigma(), options).report;
    ASSERT_EQ(report.notes.size(), 1u);
    EXPECT_EQ(report.notes[0],
              "tie: with 2 intervals [-1, 0] and [0, 1] fit equally badly; the first of them is "
              "halved");
    options.intervals = 2;
    EXPECT_TRUE(fit(table.without_sigma(), options).report.notes.empty());
}

TEST(FitByInsertion, WarnsOfAsManyCoefficientsAsSamples) {
    testing::FitTable table;
    testing::Noise noise(3);
    for (int i = 0; i < 30; ++i) {
        table.x.push_back(i);
        table.y.push_back(noise.normal());
    }
    FitOptions options;
    options.sigma = 1;
    options.delta2 = 1e-9;
    const FitReport report = fit(table.without_sigma(), options).report;
    ASSERT_EQ(report.notes.size(), 1u);
    EXPECT_NE(report.notes[0].find(" for 30 samples"), std::string::npos);
}

}  // namespace fit_path_test
}  // namespace batten
