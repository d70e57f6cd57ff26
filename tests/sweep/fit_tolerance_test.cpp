#include "fit_samples.hpp"

#include <gtest/gtest.h>

/// Few knots to a tolerance: it is kept, and tighter ones cost more.
namespace batten {
namespace fit_tolerance_test {

testing::FitTable exact(double (*f)(double), int count) {
    testing::FitTable table;
    for (int i = 0; i < count; ++i) {
        table.x.push_back(static_cast<double>(i) / (count - 1));
        table.y.push_back(f(table.x.back()));
        table.sigma.push_back(1);
    }
    return table;
}

double wave(double x) { return std::sin(8 * x * x); }
double kink(double x) { return std::fabs(x - 0.3); }

TEST(FitToATolerance, KeepsIt) {
    for (const bool is_closed : {false, true}) {
        for (int degree = 1; degree <= 5; degree += 2) {
            int before = 0;
            for (double tolerance = 1e-1; tolerance > 1e-5; tolerance *= 0.1) {
                FitOptions options;
                options.degree = degree;
                options.closed = is_closed;
                options.tolerance = absolute(tolerance);
                const auto table = is_closed
                                       ? exact([](double x) {
                                             return std::exp(std::sin(2 * std::numbers::pi * x));
                                         }, 201)
                                       : exact(wave, 201);
                const Fit made = fit(table.view(), options);
                EXPECT_EQ(made.report.status, Status::met) << degree << " " << tolerance;
                EXPECT_LE(*made.report.max_residual, tolerance);
                EXPECT_GE(made.report.parameters, before) << degree << " " << tolerance;
                before = made.report.parameters;
            }
        }
    }
}

TEST(FitToATolerance, MovesKnotsToWhereTheyServe) {
    FitOptions options;
    options.degree = 1;
    options.tolerance = relative(1e-6);
    const Fit made = fit(exact(kink, 101).view(), options);
    EXPECT_EQ(made.report.status, Status::met);
    EXPECT_LE(made.report.intervals, 3);
}

TEST(FitToATolerance, TakesFewerKnotsThanInsertion) {
    const auto table = exact(wave, 401);
    FitOptions options;
    options.tolerance = absolute(1e-3);
    const Fit made = fit(table.view(), options);
    FitOptions insertion;
    for (int n = made.report.intervals;; ++n) {
        insertion.intervals = n;
        if (*fit(table.view(), insertion).report.max_residual <= 1e-3) break;
        ASSERT_LT(n, 200);
    }
    EXPECT_LT(made.report.intervals, *insertion.intervals);
}

TEST(FitToATolerance, SaysWhereItCannotBeKept) {
    // Two values at one abscissa.
    testing::FitTable table = exact(wave, 50);
    table.x.push_back(table.x[20]);
    table.y.push_back(table.y[20] + 1);
    table.sigma.push_back(1);
    FitOptions options;
    options.tolerance = absolute(0.1);
    EXPECT_EQ(fit(table.view(), options).report.status, Status::not_met);
}

}  // namespace fit_tolerance_test
}  // namespace batten
