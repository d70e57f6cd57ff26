#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "batten/io/table.hpp"
#include "batten/make/fair.hpp"
#include "fair_samples.hpp"
#include "shared.hpp"

namespace batten {
namespace fair_law_test {

Points noisy_wave(unsigned seed, double sigma) {
    Points points(0, 2);
    testing::NumpyRandom random(seed);
    for (int i = 0; i < 80; ++i) {
        const double t = 0.07 * i;
        const double x = t + sigma * random.normal();
        points.push_back(std::vector<double>{x, std::sin(t) + sigma * random.normal()});
    }
    return points;
}

Points noisy_ring(unsigned seed, double sigma) {
    Points points(0, 2);
    testing::NumpyRandom random(seed);
    for (int i = 0; i < 90; ++i) {
        const double t = 2 * std::numbers::pi * i / 90;
        const double x = 2 * std::cos(t) + sigma * random.normal();
        points.push_back(std::vector<double>{x, std::sin(t) + sigma * random.normal()});
    }
    return points;
}

/// Every kind of fairing that the laws are asked of.
std::vector<FairOptions> kinds() {
    FairOptions plain;
    plain.sigma = 0.004;
    FairOptions bounded = plain, spiral = plain, filter = plain, found;
    bounded.tolerance = absolute(0.006);
    spiral.alpha.value = 0.5;
    spiral.fix_ends = FixEnds::tangent;
    filter.engine = FairEngine::filter;
    filter.sweeps = 40;
    return {plain, bounded, spiral, filter, found};
}

TEST(Fairing, ScalesExactly) {
    const Points points = noisy_wave(1, 0.004);
    Points large(points);
    for (double& x : large.coordinates()) x *= 1024;
    for (FairOptions options : kinds()) {
        const Fairing small = fair(points, options);
        if (options.sigma) *options.sigma *= 1024;
        if (options.tolerance) options.tolerance->value *= 1024;
        const Fairing big = fair(large, options);
        EXPECT_EQ(small.report.sweeps, big.report.sweeps);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_EQ(1024 * small.points(i, 0), big.points(i, 0));
            EXPECT_EQ(1024 * small.points(i, 1), big.points(i, 1));
        }
    }
}

TEST(Fairing, DoesNotMindTheDirectionOrAMirror) {
    const Points points = noisy_wave(2, 0.004);
    const std::size_t n = points.size();
    Points back(n, 2), mirrored(points);
    for (std::size_t i = 0; i < n; ++i) {
        back(i, 0) = points(n - 1 - i, 0);
        back(i, 1) = points(n - 1 - i, 1);
        mirrored(i, 1) = -points(i, 1);
    }
    FairOptions options;
    options.sigma = 0.004;
    options.lambda = 1e-2;
    const Points p = fair(points, options).points, q = fair(back, options).points,
                 r = fair(mirrored, options).points;
    for (std::size_t i = 0; i < n; ++i) {
        for (int k = 0; k < 2; ++k) {
            EXPECT_NEAR(p(i, k), q(n - 1 - i, k), 1e-5);  // steps end at sigma / 1000
            EXPECT_NEAR(p(i, k), (k == 1 ? -1 : 1) * r(i, k), 1e-12);
        }
    }
}

TEST(Fairing, MovesNoPointFurtherThanTheTolerance) {
    for (const double tolerance : {0.004, 0.006, 0.012}) {
        for (const unsigned seed : {1u, 2u, 3u}) {
            FairOptions options;
            options.sigma = 0.004;
            options.tolerance = absolute(tolerance);
            const Fairing made = fair(noisy_wave(seed, 0.004), options);
            EXPECT_LE(made.report.max_displacement, tolerance * (1 + 1e-9));
            options.closed = true;
            EXPECT_LE(fair(noisy_ring(seed, 0.004), options).report.max_displacement,
                      tolerance * (1 + 1e-9));
        }
    }
}

/// A side line of a car, heights rounded to whole millimetres.
TEST(Fairing, ComesToRestOnACarForEveryAlphaAndAlmostEverySigma) {
    const Points points = read_points(testing::source_file("cases/points/car-side.csv"));
    for (const double alpha : {-1.0, 0.0, 0.5, 1.0, 2.0}) {
        for (const double sigma : {0.05, 0.1, 0.15, 0.29}) {
            for (const FixEnds ends : {FixEnds::none, FixEnds::position, FixEnds::curvature}) {
                FairOptions options;
                options.alpha.value = alpha;
                options.sigma = sigma;
                options.tolerance = absolute(1);
                options.fix_ends = ends;
                EXPECT_EQ(fair(points, options).report.status, Status::met)
                    << alpha << ' ' << sigma << ' ' << int(ends);
            }
        }
    }
}

TEST(Fairing, HoldsTheEndsAsAsked) {
    const Points points = noisy_wave(4, 0.004);
    const std::size_t n = points.size();
    for (const FairEngine engine : {FairEngine::gauss_newton, FairEngine::filter}) {
        for (int held = 1; held <= 3; ++held) {
            FairOptions options;
            options.engine = engine;
            options.sigma = 0.004;
            options.fix_ends = static_cast<FixEnds>(held);
            const Points p = fair(points, options).points;
            for (std::size_t i = 0; i < static_cast<std::size_t>(held); ++i) {
                EXPECT_EQ(p(i, 0), points(i, 0));
                EXPECT_EQ(p(i, 1), points(i, 1));
                EXPECT_EQ(p(n - 1 - i, 1), points(n - 1 - i, 1));
            }
            EXPECT_NE(p(n / 2, 1), points(n / 2, 1));
        }
    }
}

TEST(Fairing, OfARingHasNoSeam) {
    const Points ring = noisy_ring(5, 0.002);
    const std::size_t n = ring.size(), shift = 31;
    Points turned(n, 2);
    for (std::size_t i = 0; i < n; ++i) {
        turned(i, 0) = ring((i + shift) % n, 0);
        turned(i, 1) = ring((i + shift) % n, 1);
    }
    FairOptions options;
    options.sigma = 0.002;
    options.closed = true;
    options.lambda = 0.01;
    const Points p = fair(ring, options).points, q = fair(turned, options).points;
    double moved = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (int k = 0; k < 2; ++k) {
            EXPECT_NEAR(p((i + shift) % n, k), q(i, k), 1e-5);
            moved = std::fmax(moved, std::fabs(p(i, k) - ring(i, k)));
        }
    }
    EXPECT_GT(moved, 0.002);
    options.as = FairForm::arcs;
    const Fairing chain = fair(ring, options);
    ASSERT_TRUE(chain.curve);
    EXPECT_TRUE(chain.curve->is_closed());
}

TEST(Fairing, NeedsNoSmallSpacingForLongWaves) {
    // 4,000 points: the cutoff is longer than 2,000 points.
    const LogAestheticCurve arc = testing::arc_over_chord(-1, 75 * std::numbers::pi / 180, 3);
    const Points noisy = testing::with_noise(testing::points_on(arc, 4000), 0.001, 1, false);
    FairOptions options;
    options.sigma = 0.001;
    options.lambda = 100;
    const Points p = fair(noisy, options).points;
    Points some(0, 2);
    for (std::size_t i = 0; i < p.size(); i += 40) some.push_back(p[i]);
    EXPECT_LT(testing::distance_from(arc, some), 7e-5);  // 0.035 sigma is ideal
}

/// Both sides of a round nose, from tail to tail: close together at the nose, far apart behind it.
Points nose(int half) {
    Points points(0, 2);
    for (int i = -half; i <= half; ++i) {
        const double u = static_cast<double>(i) / half, size = std::fabs(u);
        const double x = size * size * size;
        points.push_back(std::vector<double>{x, 0.2 * std::copysign(std::sqrt(x) * (1.1 - x), u)});
    }
    return points;
}

TEST(Fairing, KeepsAShapeThatItsSigmaCannotExplain) {
    FairOptions options;
    for (const double sigma : {1e-4, 1e-6}) {
        options.sigma = sigma;
        const Fairing made = fair(nose(30), options);
        EXPECT_LE(made.report.rms_displacement, 1.5 * sigma);
        EXPECT_EQ(made.report.status, Status::met);
    }
}

TEST(Fairing, MovesNothingWhereLambdaAsksForNothing) {
    FairOptions options;
    options.sigma = 1e-6;
    options.lambda = 1e-30;
    EXPECT_LE(fair(nose(30), options).report.max_displacement, 1e-12);
    Points crowded = noisy_wave(1, 0.01);
    Points points(0, 2);
    for (std::size_t i = 0; i < crowded.size(); ++i) {
        points.push_back(crowded[i]);
        if (i % 10 == 5) {
            points.push_back(std::vector<double>{crowded(i, 0) + 0.001, crowded(i, 1) + 0.002});
        }
    }
    EXPECT_LE(fair(points, options).report.max_displacement, 1e-12);
}

TEST(Fairing, SaysWhereItMovesPointsFarBeyondTheirNoise) {
    FairOptions options;
    options.sigma = 1e-4;
    options.lambda = 1e-3;
    const Fairing made = fair(nose(30), options);
    EXPECT_GT(made.report.rms_displacement, 2e-4);
    ASSERT_FALSE(made.report.notes.empty());
    EXPECT_NE(made.report.notes.back().find("more than noise explains"), std::string::npos);
}

}  // namespace fair_law_test
}  // namespace batten
