#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "batten/make/fair.hpp"
#include "batten/shape/log_aesthetic.hpp"
#include "fair_samples.hpp"
#include "make/fair/filter.hpp"
#include "shared.hpp"

namespace batten {
namespace fair_filter_test {

constexpr const char* figure_2 = "reference/log-aesthetic/fig2_seeds.csv";

FairOptions filter_options(int window) {
    FairOptions options;
    options.alpha.value = 0.5;
    options.engine = FairEngine::filter;
    options.window = window;
    return options;
}

double least_curvature(const Points& p) {
    double least = 1e300;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        const double ax = p(i, 0) - p(i - 1, 0), ay = p(i, 1) - p(i - 1, 1);
        const double bx = p(i + 1, 0) - p(i, 0), by = p(i + 1, 1) - p(i, 1);
        least = std::min(least, ax * by - ay * bx);
    }
    return least;
}

TEST(FairFilter, MakesTheNoisyPointsOfThePapersFigureFair) {
    SKIP_UNLESS_SHARED(figure_2);
    const std::string text = testing::read_text(*testing::shared_file(figure_2));
    const auto table = testing::parse_csv(text.substr(text.find("kind,")));
    std::map<std::string, Points> sets;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        Points& set = sets.try_emplace(table.text(i, "kind") + table.text(i, "seed"), 0, 2)
                          .first->second;
        set.push_back(std::vector<double>{table.number(i, "x"), table.number(i, "y")});
    }
    ASSERT_EQ(sets.size(), 16u);
    std::vector<double> residuals;
    for (const auto& [name, points] : sets) {
        const Fairing made = fair(points, filter_options(9));
        EXPECT_EQ(made.report.sweeps, 250);
        EXPECT_LT(least_curvature(points), 0) << name;
        EXPECT_GT(least_curvature(made.points), 0) << name;
        EXPECT_LT(made.report.linearity_residual, 0.05) << name;
        residuals.push_back(made.report.linearity_residual);
    }
    std::sort(residuals.begin(), residuals.end());
    EXPECT_LT(0.5 * (residuals[7] + residuals[8]), 5e-4);
}

/// rho^0.5 = s + 0.6, s in [0, 1].
LogAestheticCurve exact_arc() {
    return {std::vector<double>{0, 0}, 0, {0.5, 1, 1 / 0.36, 1 / 2.56}};
}

double largest_distance(const Curve& curve, const Points& points) {
    double most = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        most = std::max(most, nearest(curve, points[i]).distance);
    }
    return most;
}

TEST(FairFilter, LeavesExactPointsOnTheirCurve) {
    const Curve arc = exact_arc();
    const Points points = testing::points_on(arc, 40);
    EXPECT_LT(largest_distance(arc, fair(points, filter_options(9)).points), 4e-6);
    FairOptions kept = filter_options(9);
    kept.spacing = FairSpacing::kept;
    EXPECT_LT(largest_distance(arc, fair(points, kept).points), 1e-6);
}

TEST(FairFilter, KeepsUnevenSpacingWhereAsked) {
    const Curve arc = exact_arc();
    Points points(0, 2);
    double s = 0;
    for (int i = 0; i < 40; ++i) {
        points.push_back(arc(s / (20 + 19 * 2)));
        s += i % 2 == 0 ? 1 : 2;
    }
    FairOptions options = filter_options(9);
    options.spacing = FairSpacing::kept;
    const Points kept = fair(points, options).points, equal = fair(points, filter_options(9)).points;
    const auto step = [](const Points& p, std::size_t i) {
        return std::hypot(p(i + 1, 0) - p(i, 0), p(i + 1, 1) - p(i, 1));
    };
    EXPECT_NEAR(step(kept, 11) / step(kept, 10), 2, 2e-3);
    EXPECT_NEAR(step(equal, 11) / step(equal, 10), 1, 1e-3);
    EXPECT_LT(largest_distance(arc, kept), 1.4e-5);
    EXPECT_LT(largest_distance(arc, equal), 1.5e-4);
}

TEST(FairFilter, MovesNoPointFurtherThanTheTolerance) {
    const Points noisy = testing::with_noise(testing::points_on(exact_arc(), 40), 0.002, 1, false);
    FairOptions options = filter_options(5);
    options.tolerance = absolute(0.004);
    const Fairing made = fair(noisy, options);
    EXPECT_LE(made.report.max_displacement, 0.004 * (1 + 1e-12));
    EXPECT_GT(made.report.max_displacement, 0.0039);
}

TEST(FairFilter, HoldsInflectionsAndExtremaWhereAskedToSplit) {
    Points points(0, 2);
    for (int i = 0; i < 41; ++i) {
        const double x = -1 + i / 20.0;
        points.push_back(std::vector<double>{x, x * x});
    }
    const auto off = [](const Points& p) {
        double most = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            most = std::max(most, std::fabs(p(i, 1) - p(i, 0) * p(i, 0)));
        }
        return most;
    };
    FairOptions options = filter_options(5);
    const Points whole = fair(points, options).points;
    options.split = true;
    const Points split = fair(points, options).points;
    EXPECT_GT(off(whole), 0.1);  // the apex is flattened
    EXPECT_EQ(split(20, 1), 0);
    EXPECT_LT(off(split), 0.1 * off(whole));
}

}  // namespace fair_filter_test
}  // namespace batten
