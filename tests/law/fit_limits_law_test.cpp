#include "fit_samples.hpp"

#include <gtest/gtest.h>

/// Fits within limits: the limits are kept, and nothing within them is better.
namespace batten {
namespace fit_limits_law_test {

using testing::FitTable;
using testing::Noise;

/// A rising step with noise: sigma 0.05.
FitTable step_table(std::uint64_t seed) {
    Noise noise(seed);
    FitTable table;
    for (int i = 0; i <= 120; ++i) {
        const double x = i / 120.0;
        table.x.push_back(x);
        table.y.push_back(1 / (1 + std::exp(-25 * (x - 0.5))) + 0.05 * noise.normal());
        table.sigma.push_back(0.05);
    }
    return table;
}

FitOptions over_12(int degree) {
    FitOptions options;
    options.degree = degree;
    options.knots = KnotPlacement::equal;
    options.intervals = 12;
    return options;
}

double delta2_of(const FitTable& table, const SplineFunction& s) {
    double sum = 0;
    for (std::size_t i = 0; i < table.x.size(); ++i) {
        const double e = (table.y[i] - s(table.x[i])) / table.sigma[i];
        sum += e * e;
    }
    return sum;
}

TEST(FitLimits, AtTheEndsAreMetExactly) {
    const FitTable table = step_table(1);
    for (int degree = 1; degree <= 5; ++degree) {
        FitOptions options = over_12(degree);
        options.start_value = 0.125;
        options.end_slope = -2;
        options.end_value = 1.5;
        const Fit made = fit(table.view(), options);
        EXPECT_EQ(made.report.status, Status::met);
        EXPECT_EQ(made.spline(0), 0.125);
        EXPECT_NEAR(made.spline(1), 1.5, 1e-15);
        EXPECT_NEAR(made.spline(1, 1), -2, 1e-12);
        EXPECT_EQ(made.report.parameters, 12 + degree - 3);
        EXPECT_LT(made.covariance.deviation(0), 1e-12);
        EXPECT_LT(made.covariance.deviation(1, 1), 1e-9);
        EXPECT_GT(made.covariance.deviation(0.5), 1e-3);
    }
}

TEST(FitLimits, OfASlopeAloneLeaveTheValueFree) {
    FitOptions options = over_12(3);
    options.start_slope = 0;
    const Fit made = fit(step_table(2).view(), options);
    EXPECT_NEAR(made.spline(0, 1), 0, 1e-13);
    EXPECT_GT(made.covariance.deviation(0), 1e-3);
}

TEST(FitLimits, KeepMonotoneFitsFromFalling) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const FitTable table = step_table(seed);
        FitOptions options = over_12(3);
        const Fit plain = fit(table.view(), options);
        options.monotone = Direction::by_data;
        const Fit made = fit(table.view(), options);
        EXPECT_EQ(made.report.status, Status::met);
        for (int i = 0; i <= 1000; ++i) EXPECT_GE(made.spline(i / 1000.0, 1), -1e-12) << seed;
        EXPECT_GE(made.report.delta2, plain.report.delta2);
        EXPECT_LT(made.report.delta2, plain.report.delta2 + 60);
    }
}

TEST(FitLimits, GiveTheMeanWhereTheDataGoTheOtherWay) {
    FitTable table;
    for (int i = 0; i <= 50; ++i) {
        table.x.push_back(i);
        table.y.push_back(-i);
        table.sigma.push_back(1);
    }
    FitOptions options = over_12(3);
    options.monotone = Direction::up;
    const Fit made = fit(table.view(), options);
    for (int i = 0; i <= 50; ++i) EXPECT_NEAR(made.spline(i), -25, 1e-9);
}

TEST(FitLimits, KeepConvexFitsFromBendingTheOtherWay) {
    Noise noise(5);
    FitTable table;
    for (int i = 0; i <= 200; ++i) {
        const double x = i / 100.0 - 1;
        table.x.push_back(x);
        table.y.push_back(std::fabs(x) + 0.05 * noise.normal());
        table.sigma.push_back(0.05);
    }
    for (const Direction convex : {Direction::by_data, Direction::up}) {
        FitOptions options = over_12(3);
        options.convex = convex;
        const Fit made = fit(table.view(), options);
        for (int i = 0; i <= 1000; ++i) {
            EXPECT_GE(made.spline(std::min(1.0, i / 500.0 - 1), 2), -1e-9);
        }
        EXPECT_LT(delta2_of(table, made.spline), 1.5 * static_cast<double>(table.x.size()));
    }
    FitOptions options = over_12(3);
    options.convex = Direction::down;
    const Fit concave = fit(table.view(), options);
    for (int i = 0; i <= 1000; ++i) {
        EXPECT_LE(concave.spline(std::min(1.0, i / 500.0 - 1), 2), 1e-9);
    }
}

TEST(FitLimits, LeaveNothingBetterWithinThem) {
    // Steps in all directions that keep to rising coefficients do not lower delta2.
    const FitTable table = step_table(3);
    FitOptions options = over_12(3);
    options.monotone = Direction::up;
    const Fit made = fit(table.view(), options);
    const std::vector<double>& c = made.report.coefficients;
    Noise noise(6);
    for (int round = 0; round < 500; ++round) {
        std::vector<double> other = c;
        for (double& x : other) x += 1e-3 * noise.normal();
        std::sort(other.begin(), other.end());
        const SplineFunction s(made.report.knots, other, 3);
        EXPECT_GE(delta2_of(table, s), made.report.delta2 * (1 - 1e-12));
    }
}

TEST(FitLimits, ThatTheDataKeepAnywayChangeNothing) {
    FitTable table;
    for (int i = 0; i <= 60; ++i) {
        table.x.push_back(i / 60.0);
        table.y.push_back(std::exp(table.x.back()));
        table.sigma.push_back(0.01);
    }
    FitOptions options = over_12(3);
    const Fit plain = fit(table.view(), options);
    options.monotone = Direction::up;
    options.convex = Direction::up;
    const Fit made = fit(table.view(), options);
    for (std::size_t j = 0; j < plain.report.coefficients.size(); ++j) {
        EXPECT_NEAR(made.report.coefficients[j], plain.report.coefficients[j], 1e-11);
    }
}

TEST(FitLimits, ScaleExactlyWithTheOrdinates) {
    const FitTable table = step_table(4);
    FitTable large = table;
    for (double& y : large.y) y *= 0x1p20;
    for (double& s : large.sigma) s *= 0x1p20;
    FitOptions options = over_12(3);
    options.monotone = Direction::by_data;
    options.start_value = 0.0;
    const Fit one = fit(table.view(), options), other = fit(large.view(), options);
    for (std::size_t j = 0; j < one.report.coefficients.size(); ++j) {
        EXPECT_EQ(other.report.coefficients[j], one.report.coefficients[j] * 0x1p20);
    }
}

TEST(FitLimits, CloseTheBandAlsoWhereKnotsAreChosen) {
    FitOptions options;
    options.start_value = 0.1;
    options.end_value = 0.9;
    const FitBand band = fit(step_table(3).view(), options).report.covariance_band;
    EXPECT_NEAR(band.lower.front(), 0.1, 1e-6);
    EXPECT_NEAR(band.upper.front(), 0.1, 1e-6);
    EXPECT_NEAR(band.lower.back(), 0.9, 1e-6);
    EXPECT_NEAR(band.upper.back(), 0.9, 1e-6);
}

TEST(FitLimits, LeaveABandAsNarrowAsTheErrorsSayWhereKnotsAreChosen) {
    FitOptions options;
    options.monotone = Direction::down;  // against the data: far from every fit without limits
    const FitBand band = fit(step_table(3).view(), options).report.covariance_band;
    for (std::size_t i = 0; i < band.x.size(); ++i) {
        EXPECT_LT(band.upper[i] - band.lower[i], 0.2) << band.x[i];
    }
}

TEST(FitLimits, ThatContradictEachOtherAreNotMet) {
    // Falling throughout, and higher at the end than at the start.
    Noise noise(8);
    for (int round = 0; round < 60; ++round) {
        const double error = std::pow(10.0, -0.5 - 2.5 * noise.uniform());
        FitTable table;
        for (int i = 0; i <= 60; ++i) {
            table.x.push_back(i / 60.0);
            table.y.push_back(50 - table.x.back() * table.x.back() + error * noise.normal());
            table.sigma.push_back(error);
        }
        FitOptions options = over_12(1 + round % 4);
        options.intervals = 1 + round % 7;
        options.monotone = Direction::down;
        options.start_value = 49.9;
        options.end_value = 49.9 + std::pow(10.0, -3 * noise.uniform());
        const Fit made = fit(table.view(), options);
        EXPECT_EQ(made.report.status, Status::not_met) << round;
        EXPECT_FALSE(made.report.notes.empty());
        options.end_value = 49.9 - std::pow(10.0, -3 * noise.uniform());
        const Fit falling = fit(table.view(), options);
        EXPECT_EQ(falling.report.status, Status::met) << round;
        EXPECT_EQ(falling.report.coefficients.front(), *options.start_value);
        EXPECT_EQ(falling.report.coefficients.back(), *options.end_value);
    }
}

TEST(FitLimits, ByTheDataGoTheWayOfTheLeastDelta2) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Noise noise(seed);
        FitTable table;
        for (int i = 0; i < 100; ++i) {
            const double x = i / 99.0;
            table.x.push_back(x);
            table.y.push_back((x - 0.3) * (x - 0.3) + 0.1 * noise.normal());
            table.sigma.push_back(0.1);
        }
        const auto delta2 = [&](Direction monotone, Direction convex) {
            FitOptions options = over_12(3);
            options.monotone = monotone;
            options.convex = convex;
            return fit(table.view(), options).report.delta2;
        };
        constexpr Direction up = Direction::up, down = Direction::down, any = Direction::by_data;
        EXPECT_EQ(delta2(Direction::free, any),
                  std::min(delta2(Direction::free, up), delta2(Direction::free, down)));
        EXPECT_EQ(delta2(any, Direction::free),
                  std::min(delta2(up, Direction::free), delta2(down, Direction::free)));
        EXPECT_EQ(delta2(any, any), std::min({delta2(up, up), delta2(up, down), delta2(down, up),
                                              delta2(down, down)}));
    }
}

TEST(FitLimits, MayHoldEveryCoefficient) {
    FitTable table;
    for (int i = 0; i <= 10; ++i) {
        table.x.push_back(0.1 * i);
        table.y.push_back(0.3 * i + (i % 2 ? 0.25 : -0.25));
        table.sigma.push_back(0.5);
    }
    FitOptions options;
    options.knots = KnotPlacement::equal;
    options.intervals = 1;
    options.start_value = 0;
    options.end_value = 3;
    for (const int degree : {1, 3}) {
        options.degree = degree;
        if (degree == 3) options.start_slope = options.end_slope = 3;
        for (const Direction convex : {Direction::free, Direction::up, Direction::by_data}) {
            options.convex = convex;
            options.monotone = convex;
            const Fit made = fit(table.view(), options);
            EXPECT_EQ(made.report.status, Status::met);
            EXPECT_EQ(made.report.parameters, 0);
            EXPECT_NEAR(made.report.delta2, 11 * 0.25, 1e-12);
            EXPECT_NEAR(*made.report.sigma2, 0.25, 1e-12);
            for (const double x : {0.0, 0.4, 1.0}) {
                EXPECT_NEAR(made.spline(x), 3 * x, 1e-14);
                EXPECT_LT(made.covariance.deviation(x), 1e-12);
            }
        }
    }
}

}  // namespace fit_limits_law_test
}  // namespace batten
