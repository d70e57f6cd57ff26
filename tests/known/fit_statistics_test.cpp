#include "batten/make/fit_statistics.hpp"

#include "batten/base/error.hpp"
#include "shared_json.hpp"

namespace batten {
namespace fit_statistics_test {

TEST(FitStatistics, GiveAllPrintedBlocksOfThePaper) {
    const char* const file = "reference/fitting/figure_stats.json";
    SKIP_UNLESS_SHARED(file);
    const nlohmann::json blocks = testing::shared_json(file);
    ASSERT_EQ(blocks.size(), 24u);
    for (const auto& block : blocks) {
        const std::size_t n = block["N"];
        const int p = block["p"];
        const double delta2 = block["delta2"], sigma2 = block["sigma2"];
        const double aic = block["aic_printed"];
        const FitCriteria c = fit_criteria(delta2, n, p, SigmaKnowledge::known);
        EXPECT_NEAR(c.aic / aic, 1, 1e-4) << block["fig"];
        ASSERT_TRUE(c.sigma2);
        // sigma2 is printed with five digits, and one of Fig. 2.9's is misread.
        EXPECT_NEAR(*c.sigma2 / sigma2, 1, block["fig"] == "2.9" ? 2.5e-4 : 6e-5) << block["fig"];
    }
}

TEST(FitStatistics, GiveTheCriteriaOfAWorkedExample) {
    // delta2 = 100, N = 50, p = 5, worked by hand.
    const FitCriteria known = fit_criteria(100, 50, 5, SigmaKnowledge::known);
    EXPECT_DOUBLE_EQ(known.aic, 50 * std::log(100.0) + 10);
    EXPECT_DOUBLE_EQ(known.aicc, 50 * std::log(100.0) + 10 + 60.0 / 44);
    EXPECT_DOUBLE_EQ(known.bic, 100 + 5 * std::log(50.0));
    EXPECT_DOUBLE_EQ(known.gcv, 50 * 100.0 / (45 * 45));
    const FitCriteria unknown = fit_criteria(100, 50, 5, SigmaKnowledge::unknown);
    EXPECT_NEAR(unknown.bic, 50 * std::log(2.0) + 5 * std::log(50.0), 1e-12);
}

TEST(FitStatistics, HaveNoSigma2WhereNothingIsLeft) {
    EXPECT_FALSE(fit_criteria(0, 5, 5, SigmaKnowledge::known).sigma2);
    EXPECT_TRUE(std::isfinite(fit_criteria(0, 5, 5, SigmaKnowledge::unknown).bic));
}

TEST(FitStatistics, AreSureOfExactData) {
    for (const double degrees : {1.0, 10.0, 1e3, 5e4, 2e8}) {
        for (const double share : {0.0, 1e-30, 1e-20}) {
            EXPECT_NEAR(chi2_survival(share * degrees, degrees), 1, 1e-9);
        }
    }
    // 1 - exp(-1e-3), and the same by a series in x.
    EXPECT_NEAR(1 - chi2_survival(2e-3, 2), 9.995001666250084e-4, 1e-16);
    EXPECT_NEAR(chi2_survival(0.02, 10), 1 - 8.264e-13, 1e-15);
}

TEST(FitStatistics, GiveTabulatedQuantiles) {
    // Abramowitz and Stegun, tables 26.8 and 26.10.
    EXPECT_NEAR(chi2_quantile(0.05, 10), 18.307, 5e-4);
    EXPECT_NEAR(chi2_quantile(0.95, 20), 10.851, 5e-4);
    EXPECT_NEAR(chi2_survival(18.307038053275146, 10), 0.05, 1e-14);
    EXPECT_NEAR(student_quantile(0.05, 10), 2.228, 5e-4);
    EXPECT_NEAR(student_quantile(0.05, 1), 12.706, 5e-4);
    EXPECT_NEAR(student_quantile(0.05, 1e9), 1.959963984540054, 1e-9);
}

TEST(FitStatistics, FindFewRunsUnlikely) {
    // 20 of each sign: mean 21 runs, variance 380 / 39.
    const auto mean = runs_probability(21, 20, 20), few = runs_probability(10, 20, 20);
    ASSERT_TRUE(mean && few);
    EXPECT_NEAR(*mean, 0.5636, 1e-3);
    EXPECT_LT(*few, 1e-3);
    EXPECT_FALSE(runs_probability(5, 9, 20));
}

TEST(FitStatistics, FillTheDistributionWithOnes) {
    const std::vector<double> given{0.68, 0.95, 0.99};
    const Psi phi = error_distribution(given);
    EXPECT_EQ(phi[2], 0.99);
    EXPECT_EQ(phi[3], 1);
    EXPECT_EQ(phi[9], 1);
    Psi psi = phi;
    EXPECT_TRUE(is_distributed(psi, phi));
    psi[3] = 0.999;
    EXPECT_FALSE(is_distributed(psi, phi));
}

TEST(FitStatistics, TakeErrorsForNormalWhereNoDistributionIsGiven) {
    EXPECT_EQ(error_distribution({}), error_distribution(std::vector{0.68, 0.95, 0.99}));
}

}  // namespace fit_statistics_test
}  // namespace batten
