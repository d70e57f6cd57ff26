#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "batten/make/convert.hpp"
#include "batten/make/fair.hpp"
#include "batten/measure/length.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "fair_samples.hpp"

namespace batten {
namespace fair_gauss_newton_test {

FairOptions with(double alpha, double sigma) {
    FairOptions options;
    options.alpha.value = alpha;
    options.sigma = sigma;
    return options;
}

/// Distances over sigma of 20 noisy single segments, sorted: 75 degrees, radii 1 to 3, chord 1.
std::vector<double> distances(double alpha, std::optional<double> lambda) {
    constexpr double sigma = 0.002;
    const Curve arc = testing::arc_over_chord(alpha, 75 * std::numbers::pi / 180, 3);
    const Points exact = testing::points_on(arc, 40);
    const Curve cubics = to_piecewise_cubic(arc, 1e-7);  // the nearest point is found faster there
    std::vector<double> result;
    for (unsigned seed = 0; seed < 20; ++seed) {
        FairOptions options = with(alpha, sigma);
        options.lambda = lambda;
        options.fix_ends = FixEnds::position;
        const Fairing made = fair(testing::with_noise(exact, sigma, seed, true), options);
        EXPECT_EQ(made.report.status, Status::met) << alpha << ' ' << seed;
        result.push_back(testing::distance_from(cubics, made.points) / sigma);
    }
    std::sort(result.begin(), result.end());
    return result;
}

TEST(GaussNewton, FindsSingleSegmentsOfEveryAlpha) {
    for (const double alpha : {-1.0, 0.0, 0.5, 1.0, 2.0}) {
        const std::vector<double> given = distances(alpha, 100), found = distances(alpha, {});
        EXPECT_LT(given[10], 0.19) << alpha;
        EXPECT_LT(given[18], 0.30) << alpha;
        EXPECT_LT(found[18], 0.35) << alpha;
    }
}

PiecewiseCubic bezier(const std::vector<double>& c) {
    const Points ends({c[0], c[1], c[6], c[7]}, 2);
    const Points start({3 * (c[2] - c[0]), 3 * (c[3] - c[1])}, 2);
    const Points end({3 * (c[6] - c[4]), 3 * (c[7] - c[5])}, 2);
    return PiecewiseCubic::hermite(ends, start, end, {0, 1}, false);
}

TEST(GaussNewton, KeepsTheInflectionOfACubic) {
    const Curve cubic = bezier({0, 0, 0.6, 0.9, 0.7, -0.7, 1.5, 0.2});
    const double size = length(cubic).value;
    const Points exact = testing::points_on(cubic, 60);
    const double noises[] = {0, 0.001, 0.005}, bounds[] = {5e-5, 3e-4, 1.2e-3};
    for (int k = 0; k < 3; ++k) {
        Points noisy(exact);
        testing::NumpyRandom random(5);
        for (std::size_t i = 0; i < 60; ++i) {
            for (int x = 0; x < 2; ++x) {
                const double step = random.uniform(-1, 1) * noises[k] * size;
                if (i > 0 && i < 59) noisy(i, x) += step;
            }
        }
        FairOptions options = with(-1, std::max(noises[k], 1e-4) * size / std::sqrt(3.0));
        options.fix_ends = FixEnds::position;
        const Fairing made = fair(noisy, options);
        EXPECT_LT(testing::distance_from(cubic, made.points), bounds[k] * size) << noises[k];
        EXPECT_EQ(made.report.status, Status::met);
    }
}

TEST(GaussNewton, KeepsTheApexOfAParabola) {
    Points points(0, 2);
    for (int i = 0; i < 41; ++i) {
        const double x = -1 + i / 20.0;
        points.push_back(std::vector<double>{x, x * x});
    }
    for (const double alpha : {-1.0, 0.5}) {
        FairOptions options = with(alpha, 1e-3);
        options.lambda = 0.1;
        const Points p = fair(points, options).points;
        for (std::size_t i = 0; i < 41; ++i) EXPECT_NEAR(p(i, 1), p(i, 0) * p(i, 0), 3e-4);
        const double ax = p(20, 0) - p(19, 0), ay = p(20, 1) - p(19, 1);
        const double bx = p(21, 0) - p(20, 0), by = p(21, 1) - p(20, 1);
        const double kappa = 2 * (ax * by - ay * bx) / std::hypot(ax, ay) / std::hypot(bx, by) /
                             std::hypot(ax + bx, ay + by);
        EXPECT_GT(kappa, 1.95);
    }
}

TEST(GaussNewton, LeavesExactPointsOnTheirCurve) {
    const Curve arc = LogAestheticCurve(std::vector<double>{0, 0}, 0, {0.5, 1, 1 / 0.36, 1 / 2.56});
    FairOptions options = with(0.5, 1e-4);
    options.lambda = 0.1;
    const Points p = fair(testing::points_on(arc, 40), options).points;
    for (std::size_t i = 0; i < p.size(); ++i) EXPECT_LT(nearest(arc, p[i]).distance, 1e-6);
}

TEST(GaussNewton, MakesAChainOfArcsWithinTheTolerance) {
    const Curve cubic = bezier({0, 0, 0.6, 0.9, 0.7, -0.7, 1.5, 0.2});
    FairOptions options = with(-1, 0.001);
    options.as = FairForm::arcs;
    const Fairing made = fair(testing::with_noise(testing::points_on(cubic, 80), 0.001, 3, false),
                              options);
    ASSERT_TRUE(made.curve);
    EXPECT_LT(*made.report.arcs, 20u);
    EXPECT_LE(*made.report.arcs_error, 1e-4);
    for (std::size_t i = 0; i < made.points.size(); ++i) {
        EXPECT_LT(nearest(Curve(*made.curve), made.points[i]).distance, 1.001e-4);
    }
}

}  // namespace fair_gauss_newton_test
}  // namespace batten
