#include "batten/make/fit_curve.hpp"
#include "batten/measure/nearest.hpp"
#include "fit_samples.hpp"
#include "make/fit/free_fit.hpp"

#include <gtest/gtest.h>

/// Moved knots where several coordinates share them, and on closed splines.
namespace batten {
namespace fit_curve_knots_test {

using testing::Noise;

constexpr double two_pi = 2 * std::numbers::pi;

/// Points of a rectangle of 20 x 10 with corners of radius 2, at equal steps.
Points rounded_rectangle(int count, double noise_level, std::uint64_t seed) {
    constexpr double arc = std::numbers::pi;  // of radius 2, a quarter
    constexpr double lengths[] = {8, arc, 6, arc, 16, arc, 6, arc, 8};
    constexpr double centers[4][2] = {{8, -3}, {8, 3}, {-8, 3}, {-8, -3}};
    constexpr double starts[5][2] = {{0, -5}, {10, -3}, {8, 5}, {-10, 3}, {-8, -5}};
    constexpr double ways[5][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    double perimeter = 0;
    for (const double length : lengths) perimeter += length;
    Noise noise(seed);
    Points points(0, 2);
    for (int i = 0; i < count; ++i) {
        double s = perimeter * i / count;
        int part = 0;
        while (part < 8 && s > lengths[part]) s -= lengths[part++];
        std::vector<double> p(2);
        if (part % 2 == 0) {
            for (int k = 0; k < 2; ++k) p[k] = starts[part / 2][k] + s * ways[part / 2][k];
        } else {
            const double a = 0.5 * std::numbers::pi * (part / 2 - 1) + s / 2;
            p = {centers[part / 2][0] + 2 * std::cos(a), centers[part / 2][1] + 2 * std::sin(a)};
        }
        for (double& x : p) x += noise_level * noise.normal();
        points.push_back(p);
    }
    return points;
}

struct Problem {
    fitting::Ends ends;
    fitting::KnotSet set;
};

TEST(ReducedFunctional, HasAnExactGradientForSeveralSidesAndClosedSplines) {
    Noise noise(5);
    std::vector<double> x, y, z;
    for (int i = 0; i < 80; ++i) {
        x.push_back(i / 79.0);
        y.push_back(std::sin(9 * x.back()) + 0.1 * noise.normal());
        z.push_back(std::exp(x.back()) + 0.1 * noise.normal());
    }
    fitting::Samples samples;
    samples.x = x;
    samples.sides = {y, z};
    samples.range = {0, 1};
    const fitting::LocalBasis basis(4);
    const Problem problems[] = {{fitting::Ends::open, {{0.2, 0.33, 0.7}, {1, 1, 1}}},
                                {fitting::Ends::open, {{0.2, 0.6}, {2, 1}}},
                                {fitting::Ends::closed, {{0.1, 0.33, 0.7, 0.9}, {1, 1, 1, 1}}},
                                {fitting::Ends::closed, {{0.2, 0.45, 0.8}, {1, 2, 1}}},
                                {fitting::Ends::closed, {{0.4}, {1}}}};
    for (const Problem& problem : problems) {
        fitting::FreeFit fit(samples, basis, problem.ends);
        std::vector<double> g;
        fit.gradient(problem.set, g);
        for (std::size_t v = 0; v < problem.set.size(); ++v) {
            constexpr double step = 1e-5;
            fitting::KnotSet up = problem.set, down = problem.set;
            up.at[v] += step;
            down.at[v] -= step;
            const double quotient = (fit.value(up) - fit.value(down)) / (2 * step);
            EXPECT_NEAR(g[v], quotient, 1e-6 * std::fabs(quotient) + 1e-8) << v;
        }
    }
}

TEST(PrunedCurve, NeedsHalfTheCoefficientsForARoundedRectangle) {
    FitOptions options;
    options.closed = true;
    options.sigma = 0.005;
    const Points points = rounded_rectangle(200, 0.005, 1);
    const CurveFit inserted = fit_curve(points, {}, options);
    options.knots = KnotPlacement::pruned;
    const CurveFit pruned = fit_curve(points, {}, options);
    EXPECT_EQ(pruned.report.status, Status::met);
    EXPECT_LE(2 * pruned.report.parameters, inserted.report.parameters + 6);
    EXPECT_LE(pruned.report.delta2, inserted.report.delta2);
    EXPECT_EQ(pruned.report.parameters_charged,
              pruned.report.parameters + pruned.report.intervals - 1);
    const Curve curve(pruned.curve);
    const Jet start = curve.jet(curve.domain().lo, 1), end = curve.jet(curve.domain().hi, 1);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(start[1][k], end[1][k], 1e-9);
}

TEST(PrunedCurve, TurnsSharplyAtTheCornersOfASquare) {
    Noise noise(3);
    Points square(0, 2);
    constexpr double corners[5][2] = {{1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}};
    for (int i = 0; i < 120; ++i) {
        const int side = i / 30;
        const double u = (i % 30 + 0.5) / 30;
        std::vector<double> p(2);
        for (int k = 0; k < 2; ++k) {
            p[k] = (1 - u) * corners[side][k] + u * corners[side + 1][k] + 0.002 * noise.normal();
        }
        square.push_back(p);
    }
    FitOptions options;
    options.closed = true;
    options.sigma = 0.002;
    const CurveFit inserted = fit_curve(square, {}, options);
    options.knots = KnotPlacement::pruned;
    const CurveFit made = fit_curve(square, {}, options);
    EXPECT_LT(2 * made.report.parameters, inserted.report.parameters);
    EXPECT_LT(made.report.delta2, 120);
    for (const auto& corner : corners) {
        EXPECT_LT(nearest(Curve(made.curve), std::vector<double>(corner, corner + 2)).distance, 0.01);
    }
}

TEST(FreeCurve, LiesNearerThanEqualKnotsOpenAndClosed) {
    Points ellipse(0, 2);
    Noise noise(4);
    for (int i = 0; i < 60; ++i) {
        const double a = two_pi * i / 60;
        ellipse.push_back(std::vector<double>{10 * std::cos(a) + 0.01 * noise.normal(),
                                              std::sin(a) + 0.01 * noise.normal()});
    }
    for (const bool is_closed : {false, true}) {
        FitOptions options;
        options.closed = is_closed;
        options.sigma = 0.01;
        options.intervals = 6;
        options.knots = KnotPlacement::equal;
        const CurveFit equal = fit_curve(ellipse, {}, options);
        options.knots = KnotPlacement::free;
        const CurveFit made = fit_curve(ellipse, {}, options);
        EXPECT_EQ(made.report.intervals, 6);
        EXPECT_EQ(made.report.parameters_charged, made.report.parameters + 5);
        EXPECT_LT(made.report.delta2, 0.85 * equal.report.delta2);
    }
}

TEST(FreeKnots, MoveOnClosedSplinesToo) {
    testing::FitTable table;
    Noise noise(6);
    for (int i = 0; i < 100; ++i) {
        const double a = two_pi * i / 99;
        table.x.push_back(a);
        table.y.push_back(std::exp(3 * std::cos(a - 2)) + 0.05 * noise.normal());
    }
    FitOptions options;
    options.closed = true;
    options.sigma = 0.05;
    options.intervals = 7;
    options.knots = KnotPlacement::equal;
    const Fit equal = fit(table.view(), options);
    options.knots = KnotPlacement::free;
    const Fit made = fit(table.view(), options);
    EXPECT_LT(made.report.delta2, 0.1 * equal.report.delta2);
    const Interval domain = made.spline.domain();
    for (int d = 0; d < 3; ++d) {
        EXPECT_NEAR(made.spline(domain.lo, d), made.spline(domain.hi, d), 1e-9) << d;
    }
}

}  // namespace fit_curve_knots_test
}  // namespace batten
