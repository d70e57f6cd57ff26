#include "fit_samples.hpp"

#include <gtest/gtest.h>

/// Pruned knots: where data jump, one break stands; where they are smooth, few knots are left.
namespace batten {
namespace fit_pruned_test {

using testing::FitTable;
using testing::Noise;

FitTable sampled(double (*f)(double), int count, double sigma, std::uint64_t seed) {
    Noise noise(seed);
    FitTable table;
    for (int i = 0; i < count; ++i) {
        table.x.push_back((i + 0.5) / count);
        table.y.push_back(f(table.x.back()) + sigma * noise.normal());
        table.sigma.push_back(sigma);
    }
    return table;
}

double step(double x) { return x < 0.3141 ? 0 : 1; }
double wave(double x) { return std::sin(6 * x); }

double mean_error_sq(const FitTable& table, const SplineFunction& s, double (*f)(double)) {
    double sum = 0;
    for (const double x : table.x) sum += (s(x) - f(x)) * (s(x) - f(x));
    return sum / static_cast<double>(table.x.size());
}

FitOptions pruned() {
    FitOptions options;
    options.knots = KnotPlacement::pruned;
    return options;
}

TEST(PrunedKnots, BreakOnceAtAJump) {
    double made_sum = 0, plain_sum = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const FitTable table = sampled(step, 300, 0.1, seed);
        const Fit made = fit(table.view(), pruned()), plain = fit(table.view(), {});
        made_sum += mean_error_sq(table, made.spline, step);
        plain_sum += mean_error_sq(table, plain.spline, step);
        // A cubic and the jump: its height is one parameter more, its place is charged.
        EXPECT_EQ(made.report.parameters, 5) << seed;
        EXPECT_EQ(made.report.parameters_charged, 6) << seed;
        EXPECT_EQ(made.report.notes.size(), 1u) << seed;
        const auto near = std::count_if(
            made.report.knots.begin(), made.report.knots.end(),
            [](double t) { return std::fabs(t - 0.3141) < 0.5 / 300; });
        EXPECT_EQ(near, 4) << seed;
    }
    EXPECT_LT(made_sum, 0.1 * plain_sum);
}

double tent(double x) { return x < 0.6 ? std::sin(3 * x) : std::sin(3 * x) - 8 * (x - 0.6); }

TEST(PrunedKnots, LeaveOtherDerivativesSmoothWhereOneIsBroken) {
    const FitTable table = sampled(tent, 400, 0.02, 5);
    const Fit made = fit(table.view(), pruned());
    ASSERT_EQ(made.report.notes.size(), 1u);
    EXPECT_EQ(made.report.notes[0].substr(0, 22), "knots: a corner at 0.6");
    const double at = *std::min_element(
        made.report.breaks.begin(), made.report.breaks.end(),
        [](double a, double b) { return std::fabs(a - 0.6) < std::fabs(b - 0.6); });
    const double before = std::nextafter(at, 0);
    EXPECT_NEAR(made.spline(before), made.spline(at), 1e-12);
    EXPECT_NEAR(made.spline(at, 1) - made.spline(before, 1), -8, 0.3);
    EXPECT_NEAR(made.spline(before, 2), made.spline(at, 2), 1e-9);
    EXPECT_NEAR(made.spline(before, 3), made.spline(at, 3), 1e-7);
    EXPECT_LT(mean_error_sq(table, made.spline, tent), 2e-5);
}

TEST(PrunedKnots, HaveTheErrorsOfAJumpsHeight) {
    const FitTable table = sampled(step, 300, 0.1, 4);
    const Fit made = fit(table.view(), pruned());
    ASSERT_EQ(made.report.parameters, 5);
    double trace = 0;
    for (const double x : table.x) {
        const double deviation = made.covariance.deviation(x) / 0.1;
        trace += deviation * deviation;
    }
    // The trace of the hat matrix is the number of coefficients, scaled by those charged.
    EXPECT_NEAR(trace, 5.0 * 6 / 5, 1e-9);
}

TEST(PrunedKnots, AreFewWhereTheDataAreSmooth) {
    double made_sum = 0, plain_sum = 0;
    int broken = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const FitTable table = sampled(wave, 200, 0.2, seed);
        const Fit made = fit(table.view(), pruned());
        EXPECT_LE(made.report.parameters, 9) << seed;
        broken += !made.report.notes.empty();
        made_sum += mean_error_sq(table, made.spline, wave);
        plain_sum += mean_error_sq(table, fit(table.view(), {}).spline, wave);
    }
    EXPECT_LT(made_sum, 1.25 * plain_sum);
    EXPECT_LE(broken, 1);
}

TEST(PrunedKnots, SayWhereTheyMakeACornerOrAJump) {
    FitTable table = sampled(step, 200, 0.1, 3);
    for (std::size_t i = 0; i < table.x.size(); ++i) table.y[i] = step(table.x[i]);
    const FitReport report = fit(table.view(), pruned()).report;
    ASSERT_EQ(report.notes.size(), 1u);
    EXPECT_EQ(report.notes[0].substr(0, 20), "knots: a jump at 0.3");
}

TEST(PrunedKnots, ScaleExactly) {
    const FitTable table = sampled(step, 200, 0.1, 9);
    FitTable large = table;
    for (double& y : large.y) y *= 0x1p12;
    for (double& s : large.sigma) s *= 0x1p12;
    for (double& x : large.x) x *= 0x1p-7;
    const Fit one = fit(table.view(), pruned()), other = fit(large.view(), pruned());
    ASSERT_EQ(one.report.knots.size(), other.report.knots.size());
    for (std::size_t i = 0; i < one.report.knots.size(); ++i) {
        EXPECT_EQ(other.report.knots[i], one.report.knots[i] * 0x1p-7);
    }
    for (std::size_t j = 0; j < one.report.coefficients.size(); ++j) {
        EXPECT_EQ(other.report.coefficients[j], one.report.coefficients[j] * 0x1p12);
    }
}

TEST(PrunedKnots, AreFoundWithoutKnownErrorsAndBesideOutliers) {
    FitTable table = sampled(step, 300, 0.1, 11);
    FitOptions options = pruned();
    const Fit unknown = fit(table.without_sigma(), options);
    EXPECT_LT(mean_error_sq(table, unknown.spline, step), 0.003);
    table.y[200] += 3;
    options.robust = Robust::reject;
    const Fit saved = fit(table.view(), options);
    EXPECT_LT(mean_error_sq(table, saved.spline, step), 0.003);
    EXPECT_FALSE(saved.report.rejected.empty());
}

TEST(RobustFit, DropsTheOutlierAndNoNeighbourHoweverFarOffItIs) {
    for (const Robust robust : {Robust::reject, Robust::tukey}) {
        for (const double sigmas : {8.0, 20.0, 50.0, 400.0, 1e6}) {
            FitTable table = sampled(wave, 100, 0.05, 12);
            table.y[40] += 0.05 * sigmas;
            FitOptions options;
            options.robust = robust;
            const Fit made = fit(table.view(), options);
            EXPECT_EQ(made.report.rejected, std::vector<std::size_t>{40}) << sigmas;
            EXPECT_LT(made.report.intervals, 8) << sigmas;
            if (sigmas < 20) continue;
            EXPECT_EQ(fit(table.without_sigma(), options).report.rejected,
                      std::vector<std::size_t>{40}) << sigmas;
        }
    }
}

TEST(RobustFit, DropsTheOutlierAndNoNeighbourNearTheEnds) {
    for (const Robust robust : {Robust::reject, Robust::tukey}) {
        for (const double sigmas : {58.0, -200.0}) {
            for (const std::size_t at : {1, 2, 3, 147, 148}) {
                FitTable table = sampled(wave, 150, 0.05, 14);
                table.y[at] += 0.05 * sigmas;
                FitOptions options;
                options.robust = robust;
                EXPECT_EQ(fit(table.view(), options).report.rejected, std::vector<std::size_t>{at})
                    << sigmas;
            }
        }
    }
}

TEST(RobustFit, OfRedescendingWeightsStandsOneOutlierInTwelve) {
    FitTable table = sampled(wave, 240, 0.05, 15);
    std::vector<std::size_t> outliers;
    for (std::size_t i = 5; i < 240; i += 12) {
        table.y[i] += i % 7 < 4 ? 0.5 : -0.4;
        outliers.push_back(i);
    }
    FitOptions options;
    options.robust = Robust::tukey;
    options.knots = KnotPlacement::equal;
    options.intervals = 9;
    const Fit made = fit(table.view(), options);
    EXPECT_EQ(made.report.rejected, outliers);
    EXPECT_LT(mean_error_sq(table, made.spline, wave), 2e-4);
}

TEST(RobustFit, GoesOnUntilTheWeightsStandStill) {
    FitTable table = sampled(wave, 120, 0.05, 16);
    for (std::size_t i = 3; i < 120; i += 9) table.y[i] += 0.3;
    FitOptions options;
    options.robust = Robust::huber;
    options.knots = KnotPlacement::equal;
    options.intervals = 6;
    const Fit made = fit(table.view(), options);
    const auto loss = [&](const std::vector<double>& c) {
        const SplineFunction s(made.report.knots, c, 3);
        double sum = 0;
        for (std::size_t i = 0; i < table.x.size(); ++i) {
            const double e = std::fabs(table.y[i] - s(table.x[i])) / 0.05;
            sum += e > 1.345 ? 1.345 * (2 * e - 1.345) : e * e;
        }
        return sum;
    };
    const double least = loss(made.report.coefficients);
    for (std::size_t j = 0; j < made.report.coefficients.size(); ++j) {
        for (const double step : {-1e-6, 1e-6}) {
            std::vector<double> moved = made.report.coefficients;
            moved[j] += step;
            EXPECT_GT(loss(moved), least) << j;
        }
    }
}

TEST(RobustFit, KeepsJumpsAndPeaksOfTwoSamples) {
    FitTable table = sampled(step, 200, 0.01, 13);
    table.y[150] += 3;
    table.y[151] += 3;
    FitOptions options = pruned();
    options.robust = Robust::reject;
    const Fit made = fit(table.view(), options);
    for (const std::size_t i : made.report.rejected) EXPECT_TRUE(i == 150 || i == 151) << i;
}

}  // namespace fit_pruned_test
}  // namespace batten
