#include <gtest/gtest.h>

#include <cmath>

#include "batten/make/interpolate.hpp"
#include "batten/make/motion.hpp"
#include "batten/make/sample.hpp"
#include "batten/measure/curvature.hpp"
#include "curves.hpp"
#include "random.hpp"

namespace batten {
namespace sample_law_test {

using namespace batten::testing;

Curve random_curve(Random& random, std::size_t points, int dim) {
    InterpolateOptions options;
    options.method = Method::natural_chord;
    return curve_through(random.points(points, dim), options);
}

SampleOptions by(Law law, int count) {
    SampleOptions options;
    options.law = law;
    options.count = count;
    return options;
}

double distance(const Sampling& made, std::size_t i, std::size_t j, int dim) {
    double sum = 0;
    for (int k = 0; k < dim; ++k) sum += std::pow(made.rows(i, 4 + k) - made.rows(j, 4 + k), 2);
    return std::sqrt(sum);
}

const std::vector<Law> plain_laws{Law::constant, Law::accelerate, Law::decelerate,
                                  Law::smoothstep, Law::minimum_jerk, Law::cosine,
                                  Law::trapezoid, Law::s_curve, Law::power,
                                  Law::curvature_proxy, Law::parameter};

TEST(SampleLaw, GivesTheExactCountBothEndsAndNeverWalksBack) {
    Random random(5);
    for (const int dim : {2, 3}) {
        const Curve curve = random_curve(random, 6, dim);
        for (const Law law : plain_laws) {
            const Sampling made = sample(curve, by(law, 37));
            ASSERT_EQ(made.rows.size(), 37U);
            EXPECT_EQ(made.rows(0, 3), curve.domain().lo);
            EXPECT_EQ(made.rows(36, 3), curve.domain().hi);
            const std::vector<double> first = curve(curve.domain().lo);
            const std::vector<double> last = curve(curve.domain().hi);
            for (int k = 0; k < dim; ++k) {
                EXPECT_EQ(made.rows(0, 4 + k), first[k]);
                EXPECT_EQ(made.rows(36, 4 + k), last[k]);
            }
            for (std::size_t i = 1; i < 37; ++i) EXPECT_GE(made.rows(i, 2), made.rows(i - 1, 2));
            EXPECT_LE(made.report.max_spacing_error, 1e-12 * made.report.length);
        }
    }
}

TEST(SampleLaw, SpeedIsTheDerivativeOfTheArcLengthByTime) {
    Random random(6);
    const Curve curve = random_curve(random, 5, 2);
    const ArcLengthMap map(curve);
    const std::vector<MotionLaw> laws{
        MotionLaw::accelerate(1, 3), MotionLaw::smoothstep(), MotionLaw::minimum_jerk(),
        MotionLaw::cosine(), MotionLaw::trapezoid(0.3), MotionLaw::s_curve(0.4, 0.15),
        weighted_law(curve, map, {Points({0, 1, map.length(), 3}, 2), 0.5, true}),
        parameter_law(curve, map), time_optimal_law(curve, map, {2, 3, 4}).law};
    for (std::size_t i = 0; i < laws.size(); ++i) {
        for (const double tau : {0.111, 0.283, 0.456, 0.777, 0.934}) {
            const double h = 1e-5;
            const double slope = (laws[i].at(tau + h).share - laws[i].at(tau - h).share) / (2 * h);
            EXPECT_NEAR(laws[i].at(tau).speed, slope, 2e-4 * (1 + slope)) << i << ' ' << tau;
        }
    }
}

TEST(SampleLaw, ScalesExactlyWithPowersOfTwo) {
    Random random(7);
    const Points points = random.points(6, 2), slopes = random.points(6, 2);
    const auto times = [](Points rows, double scale) {
        for (double& x : rows.coordinates()) x *= scale;
        return rows;
    };
    const Curve curve = hermite(points, slopes);
    for (const int exponent : {-30, 3, 200}) {
        const double scale = std::ldexp(1.0, exponent);
        const Curve large = hermite(times(points, scale), times(slopes, scale));
        const ArcLengthMap a(curve), b(large);
        EXPECT_EQ(b.length(), scale * a.length());
        EXPECT_EQ(b.error(), scale * a.error());
        for (const Law law : {Law::constant, Law::smoothstep, Law::cosine}) {
            const Sampling small = sample(curve, by(law, 20)), grown = sample(large, by(law, 20));
            for (std::size_t i = 0; i < 20; ++i) {
                EXPECT_EQ(grown.rows(i, 2), scale * small.rows(i, 2));
                EXPECT_EQ(grown.rows(i, 3), small.rows(i, 3));
                EXPECT_EQ(grown.rows(i, 4), scale * small.rows(i, 4));
            }
        }
    }
}

TEST(SampleLaw, ChordsAreEqualWhereTheyAreAskedToBe) {
    Random random(8);
    for (const int dim : {2, 3}) {
        const Curve curve = random_curve(random, 6, dim);
        const Sampling made = sample(curve, by(Law::chord, 60));
        EXPECT_EQ(made.report.status, Status::met);
        for (std::size_t i = 2; i < 60; ++i) {
            EXPECT_NEAR(distance(made, i, i - 1, dim), distance(made, 1, 0, dim),
                        1e-11 * made.report.length);
        }
    }
}

TEST(SampleLaw, WeightsMultiply) {
    // Of a circle the curvature is the same everywhere: it changes nothing, whatever the weights.
    const Curve circle = ellipse(2, 2);
    const double length = ArcLengthMap(circle).length();
    SampleOptions size = by(Law::weight, 25);
    size.weights = Points({0, 1, length / 3, 5, length, 2}, 2);
    SampleOptions both = size;
    both.curvature_weight = 7;
    const Sampling a = sample(circle, size), b = sample(circle, both);
    for (std::size_t i = 0; i < 25; ++i) EXPECT_NEAR(a.rows(i, 2), b.rows(i, 2), 1e-11);

    // And a timing runs through the weights: at half the way of the timing, half the weight.
    SampleOptions timed = size;
    timed.law = Law::accelerate;
    timed.count = 3;
    const Sampling c = sample(circle, timed);
    SampleOptions quarter = size;
    quarter.count = 5;
    EXPECT_NEAR(c.rows(1, 2), sample(circle, quarter).rows(1, 2), 1e-11);
}

TEST(SampleLaw, TimeBetweenSamplesIsTheIntegralOfTheDensity) {
    InterpolateOptions natural;
    natural.method = Method::natural_chord;
    const Curve curve = curve_through(Points({0, 0, 1, 0.6, 2, 0, 3, -0.7, 4, 0}, 2), natural);
    const ArcLengthMap map(curve);
    const MotionLaw law = weighted_law(curve, map, {Points(2), 0.3, false});
    // By the trapezoidal rule on many steps, for the same share of the time.
    const int steps = 20000;
    double sum = 0;
    std::vector<double> times{0};
    const auto density = [&](double s) {
        return 1 + 0.3 * std::fabs(curvature(curve.jet(map.t_of(s), 2)).value());
    };
    double before = density(0);
    for (int i = 1; i <= steps; ++i) {
        const double next = density(map.length() * i / steps);
        sum += 0.5 * (before + next) / steps;
        times.push_back(sum);
        before = next;
    }
    for (const int i : {2000, 6000, 11000, 17000}) {
        EXPECT_NEAR(law.at(times[i] / sum).share, static_cast<double>(i) / steps, 1e-7);
    }
}

TEST(SampleLaw, PassesCuspsWithCurvatureWeights) {
    const Curve cusp = bezier({0, 0, 1, 1, 0, 1, 1, 0});
    SampleOptions options = by(Law::curvature, 21);
    options.curvature_weight = 2;
    const Sampling made = sample(cusp, options);
    // Symmetric: the middle sample is the cusp.
    EXPECT_NEAR(made.rows(10, 2), 0.5 * made.report.length, 1e-6);
    for (std::size_t i = 0; i < 21; ++i) {
        EXPECT_NEAR(made.rows(i, 2) + made.rows(20 - i, 2), made.report.length, 1e-6);
        EXPECT_TRUE(std::isfinite(made.rows(i, 8)) && std::isfinite(made.rows(i, 9)));
    }
}

TEST(TimeOptimalLaw, KeepsItsLimitsOnAFineGridAndAlwaysTouchesOne) {
    Random random(10);
    for (int round = 0; round < 4; ++round) {
        const int dim = 2 + round % 2;
        const Curve curve = random_curve(random, 6, dim);
        const ArcLengthMap map(curve);
        const MotionLimits limits{1.5, 1.0 + round, 2};
        const TimedLaw fastest = time_optimal_law(curve, map, limits);
        const int steps = 4000;
        int between = 0;  // steps over a change of phase, which touch none
        double before_q = 0, before_s = 0;
        for (int i = 1; i < steps; ++i) {
            const MotionState now = fastest.law.at(static_cast<double>(i) / steps);
            const double v = now.speed * map.length() / fastest.duration;
            const double s = now.share * map.length(), q = v * v;
            const double kappa = std::fabs(curvature(curve.jet(map.t_of(s), 2)).value_or(0));
            EXPECT_LE(v, limits.speed * (1 + 1e-9));
            EXPECT_LE(q * kappa, limits.lateral * (1 + 1e-9)) << round << ' ' << i;
            if (s - before_s > 1e-5) {
                const double tangential = std::fabs(q - before_q) / (2 * (s - before_s));
                EXPECT_LE(tangential, limits.tangential * (1 + 1e-8));
                const bool touches = v > limits.speed * (1 - 1e-3) ||
                                     q * kappa > limits.lateral * (1 - 2e-2) ||
                                     tangential > limits.tangential * (1 - 2e-2);
                between += touches ? 0 : 1;
            }
            before_q = q;
            before_s = s;
        }
        EXPECT_LE(between, steps / 100) << round;
    }
}

TEST(FramesLaw, AreOfLengthOneAndPerpendicular) {
    Random random(11);
    const Curve curve = random_curve(random, 6, 3);
    SampleOptions options = by(Law::constant, 40);
    options.frames = true;
    const Sampling made = sample(curve, options);
    ASSERT_EQ(made.names.size(), 18U);
    for (std::size_t i = 0; i < made.rows.size(); ++i) {
        for (const int a : {7, 12, 15}) {
            for (const int b : {7, 12, 15}) {
                double product = 0;
                for (int k = 0; k < 3; ++k) product += made.rows(i, a + k) * made.rows(i, b + k);
                EXPECT_NEAR(product, a == b ? 1 : 0, 1e-14);
            }
        }
    }
}

TEST(FramesLaw, DoNotDependOnHowManySamplesThereAre) {
    Random random(12);
    const Curve curve = random_curve(random, 5, 3);
    SampleOptions few = by(Law::constant, 5), many = by(Law::constant, 401);
    few.frames = many.frames = true;
    const Sampling a = sample(curve, few), b = sample(curve, many);
    for (std::size_t i = 0; i < 5; ++i) {
        for (int k = 12; k < 18; ++k) EXPECT_NEAR(a.rows(i, k), b.rows(100 * i, k), 1e-6);
    }
}

TEST(SampleLaw, ParameterWithPointsBetweenMeetsEveryJoint) {
    Random random(13);
    const Curve curve = random_curve(random, 6, 2);
    SampleOptions options;
    options.law = Law::parameter;
    options.between = 3;
    const Sampling made = sample(curve, options);
    ASSERT_EQ(made.rows.size(), 21U);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(made.rows(4 * i, 3), curve.breaks()[i]);
}

TEST(SampleLaw, SpacingIsNeverMoreThanAskedForAndTimesAreFrames) {
    const Curve circle = ellipse(2, 2);
    SampleOptions options;
    options.spacing = 0.5;
    const Sampling made = sample(circle, options);
    EXPECT_EQ(made.rows.size(), 27U);  // 4 pi / 0.5 = 25.1
    SampleOptions film;
    film.duration = 2;
    film.fps = 25;
    const Sampling frames = sample(circle, film);
    ASSERT_EQ(frames.rows.size(), 51U);
    for (std::size_t i = 0; i <= 50; ++i) EXPECT_NEAR(frames.rows(i, 1), static_cast<double>(i) / 25, 1e-15);
}

}  // namespace sample_law_test
}  // namespace batten
