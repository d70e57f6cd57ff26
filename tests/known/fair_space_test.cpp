#include <gtest/gtest.h>

#include <cmath>

#include "batten/base/error.hpp"
#include "batten/make/fair.hpp"
#include "batten/shape/log_aesthetic_space.hpp"
#include "errors.hpp"
#include "fair_samples.hpp"

namespace batten {
namespace fair_space_test {

/// rho = 0.8 s + 0.6, mu = 0.5 s + 0.7 along a length of 2.
LogAestheticSpaceCurve exact_curve() { return {{1, 0.8, 0.6}, {1, 0.5, 0.7}, 2}; }

double curvature_at(const Points& p, std::size_t i) {
    const auto step = [&](std::size_t j, int k) { return p(j + 1, k) - p(j, k); };
    double a_sq = 0, b_sq = 0, d_sq = 0, dot = 0;
    for (int k = 0; k < 3; ++k) {
        const double a = step(i - 1, k), b = step(i, k);
        a_sq += a * a, b_sq += b * b, d_sq += (a + b) * (a + b), dot += a * b;
    }
    return 2 * std::sqrt((a_sq * b_sq - dot * dot) / (a_sq * b_sq * d_sq));
}

/// The rms error of the curvature over its rms.
double curvature_error(const Points& p) {
    double sum = 0, size = 0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        const double s = 2.0 * static_cast<double>(i) / static_cast<double>(p.size() - 1);
        const double k = 1 / (0.8 * s + 0.6), e = curvature_at(p, i) - k;
        sum += e * e, size += k * k;
    }
    return std::sqrt(sum / size);
}

TEST(FairingInSpace, FindsCurvatureAgain) {
    const Curve curve = exact_curve();
    const Points exact = testing::points_on(curve, 40);
    const double noises[] = {1e-4, 1e-3}, bounds[] = {0.002, 0.04};
    for (int k = 0; k < 2; ++k) {
        for (const unsigned seed : {1u, 2u, 3u}) {
            FairOptions options;
            options.alpha.value = 1;
            options.beta = 1;
            options.sigma = 2 * noises[k];
            const Points noisy = testing::with_noise(exact, 2 * noises[k], seed, false);
            const Fairing made = fair(noisy, options);
            EXPECT_GT(curvature_error(noisy), 0.1);
            EXPECT_LT(curvature_error(made.points), bounds[k]) << noises[k] << ' ' << seed;
            EXPECT_LT(testing::distance_from(curve, made.points),
                      0.7 * testing::distance_from(curve, noisy));
            EXPECT_EQ(made.report.status, Status::met);
        }
    }
}

TEST(FairingInSpace, ScalesExactlyAndKeepsEndsAndTolerance) {
    const Points noisy =
        testing::with_noise(testing::points_on(exact_curve(), 30), 0.002, 5, false);
    Points large(noisy);
    for (double& x : large.coordinates()) x *= 64;
    FairOptions options;
    options.sigma = 0.002;
    options.tolerance = absolute(0.004);
    options.fix_ends = FixEnds::position;
    const Fairing small = fair(noisy, options);
    options.sigma = 0.002 * 64;
    options.tolerance = absolute(0.004 * 64);
    const Fairing big = fair(large, options);
    for (std::size_t i = 0; i < noisy.size(); ++i) {
        for (int k = 0; k < 3; ++k) EXPECT_EQ(64 * small.points(i, k), big.points(i, k));
    }
    EXPECT_LE(small.report.max_displacement, 0.004 * (1 + 1e-12));
    EXPECT_EQ(small.points(0, 2), noisy(0, 2));
    EXPECT_EQ(small.points(29, 1), noisy(29, 1));
}

TEST(FairingInSpace, SaysWhatIsForThePlaneOnly) {
    const Points points = testing::points_on(exact_curve(), 20);
    const auto code = [&](auto change) {
        FairOptions options;
        change(options);
        return testing::code_of([&] { fair(points, options); });
    };
    EXPECT_EQ(code([](FairOptions& o) { o.closed = true; }), "fair.not-in-space");
    EXPECT_EQ(code([](FairOptions& o) { o.engine = FairEngine::filter; }), "fair.not-in-space");
    EXPECT_EQ(code([](FairOptions& o) { o.as = FairForm::arcs; }), "fair.not-in-space");
    EXPECT_EQ(code([](FairOptions& o) { o.alpha.value.reset(); }), "fair.not-in-space");
    EXPECT_EQ(code([](FairOptions&) {}), "none");
}

}  // namespace fair_space_test
}  // namespace batten
