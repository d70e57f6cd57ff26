#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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

using Vector = std::array<double, 3>;

Vector step_of(const Points& p, std::size_t i) {
    return {p(i + 1, 0) - p(i, 0), p(i + 1, 1) - p(i, 1), p(i + 1, 2) - p(i, 2)};
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double norm(const Vector& a) { return std::sqrt(dot(a, a)); }

/// The angle between the planes before and after the edge, over the mean edge.
double torsion_at(const Points& p, std::size_t edge) {
    const Vector a = step_of(p, edge - 1), b = step_of(p, edge), c = step_of(p, edge + 1);
    const Vector m = cross(a, b), n = cross(b, c);
    return 3 * dot(cross(m, n), b) /
           (norm(m) * norm(n) * norm(b) * (norm(a) + norm(b) + norm(c)));
}

/// rms errors over the rms of what should be: mu^exponent = 0.5 s + 0.7, rho^exponent = 0.8 s + 0.6.
struct BendErrors {
    double curvature = 0, torsion = 0;
};

BendErrors bend_errors(const Points& p, double exponent) {
    const double gap = 2.0 / static_cast<double>(p.size() - 1);
    double bend = 0, bend_size = 0, twist = 0, twist_size = 0;
    for (std::size_t i = 1; i + 2 < p.size(); ++i) {
        const double s = gap * static_cast<double>(i);
        const double kappa = std::pow(0.8 * s + 0.6, -1 / exponent);
        const double tau = std::pow(0.5 * (s + gap / 2) + 0.7, -1 / exponent);
        bend += std::pow(curvature_at(p, i) - kappa, 2), bend_size += kappa * kappa;
        twist += std::pow(torsion_at(p, i) - tau, 2), twist_size += tau * tau;
    }
    return {std::sqrt(bend / bend_size), std::sqrt(twist / twist_size)};
}

struct Case {
    double exponent, noise;
    BendErrors bounds;  ///< what the reference reaches with one seed
};

TEST(FairingInSpace, ReachesTheReferenceInTheMiddleOfNineSeeds) {
    const Case cases[] = {{1, 1e-4, {0.001, 0.005}},    {1, 1e-3, {0.015, 0.048}},
                          {1, 5e-3, {0.087, 0.21}},     {0.5, 1e-4, {0.002, 0.012}},
                          {0.5, 1e-3, {0.025, 0.13}}, {0.5, 5e-3, {0.17, 0.52}}};
    for (const Case& c : cases) {
        const Curve curve =
            LogAestheticSpaceCurve({c.exponent, 0.8, 0.6}, {c.exponent, 0.5, 0.7}, 2);
        FairOptions options;
        options.alpha.value = c.exponent;
        options.beta = c.exponent;
        options.sigma = c.noise;
        std::vector<double> curvatures, torsions;
        int at_rest = 0;
        for (unsigned seed = 0; seed < 9; ++seed) {
            const Fairing made = fair(
                testing::with_noise(testing::points_on(curve, 40), c.noise, seed, false), options);
            const BendErrors errors = bend_errors(made.points, c.exponent);
            curvatures.push_back(errors.curvature);
            torsions.push_back(errors.torsion);
            at_rest += made.report.status == Status::met;
        }
        std::sort(curvatures.begin(), curvatures.end());
        std::sort(torsions.begin(), torsions.end());
        EXPECT_LT(curvatures[4], c.bounds.curvature) << c.exponent << ' ' << c.noise;
        EXPECT_LT(torsions[4], c.bounds.torsion) << c.exponent << ' ' << c.noise;
        EXPECT_GE(at_rest, c.noise < 5e-3 ? 9 : 8) << c.exponent << ' ' << c.noise;
    }
}

TEST(FairingInSpace, MirrorsWithItsPoints) {
    const Curve curve = LogAestheticSpaceCurve({0.5, 0.8, 0.6}, {0.5, 0.5, 0.7}, 2);
    Points right = testing::with_noise(testing::points_on(curve, 40), 1e-3, 3, false), left(right);
    for (std::size_t i = 0; i < left.size(); ++i) left(i, 2) = -left(i, 2);
    FairOptions options;
    options.alpha.value = 0.5;
    options.beta = 0.5;
    options.sigma = 1e-3;
    const Points one = fair(right, options).points, other = fair(left, options).points;
    for (std::size_t i = 0; i < left.size(); ++i) {
        EXPECT_NEAR(one(i, 2), -other(i, 2), 1e-5);
        EXPECT_NEAR(one(i, 0), other(i, 0), 1e-5);
    }
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
