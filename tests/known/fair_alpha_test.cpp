#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "batten/base/error.hpp"
#include "batten/make/alpha.hpp"
#include "batten/make/fair.hpp"
#include "batten/measure/curvature_graph.hpp"
#include "batten/shape/log_aesthetic_space.hpp"
#include "fair_samples.hpp"

namespace batten {
namespace fair_alpha_test {

/// What 100 seeds tell about one alpha: a quarter turn, radii 1 to 4, 100 points, noise in lengths.
struct Tally {
    double bias = 0, rmse = 0, stated = 0;
};

Tally tally(double alpha, double noise) {
    constexpr int seeds = 100;
    const LogAestheticCurve arc = testing::arc_over_chord(alpha, std::numbers::pi / 2, 4);
    const Points exact = testing::points_on(arc, 100);
    Tally result;
    for (unsigned seed = 0; seed < seeds; ++seed) {
        const FoundAlpha found = alpha_of(
            testing::with_noise(exact, noise * arc.segments()[0].length, seed, false));
        EXPECT_TRUE(found.identifiable) << alpha << ' ' << seed;
        result.bias += (found.alpha - alpha) / seeds;
        result.rmse += (found.alpha - alpha) * (found.alpha - alpha) / seeds;
        result.stated += found.error / seeds;
    }
    result.rmse = std::sqrt(result.rmse);
    return result;
}

TEST(AlphaFromPoints, IsUnbiasedAndKnowsItsError) {
    for (const double alpha : {-1.0, 0.0, 0.5, 1.0, 2.0}) {
        const Tally little = tally(alpha, 1e-4), much = tally(alpha, 1e-3);
        EXPECT_LT(little.rmse, 0.025) << alpha;
        EXPECT_LT(much.rmse, 0.21) << alpha;
        for (const Tally& t : {little, much}) {
            EXPECT_LT(std::fabs(t.bias), 0.3 * t.rmse) << alpha;
            EXPECT_GT(t.stated, 0.7 * t.rmse) << alpha;
            EXPECT_LT(t.stated, 1.8 * t.rmse) << alpha;
        }
    }
}

TEST(AlphaFromPoints, IsNotIdentifiableInMuchNoise) {
    const LogAestheticCurve arc = testing::arc_over_chord(0.5, std::numbers::pi / 2, 4);
    int identifiable = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Points noisy = testing::with_noise(testing::points_on(arc, 100),
                                                 5e-3 * arc.segments()[0].length, seed, false);
        identifiable += alpha_of(noisy).identifiable;
    }
    EXPECT_LE(identifiable, 2);
}

TEST(AlphaFromPoints, ByThePapersGraphIsBiased) {
    for (const double alpha : {-1.0, 0.5, 2.0}) {
        const Points exact =
            testing::points_on(testing::arc_over_chord(alpha, std::numbers::pi / 2, 4), 100);
        const double error = std::fabs(alpha_by_graph(exact).alpha - alpha);
        EXPECT_GT(error, 0.01) << alpha;
        EXPECT_LT(error, 0.5) << alpha;
        EXPECT_NEAR(alpha_of(exact).alpha, alpha, 1e-3);
    }
}

TEST(CurvatureGraph, OfALogAestheticArcIsALineOfSlopeAlpha) {
    for (const double alpha : {-1.0, 0.0, 0.5, 2.0}) {
        const auto graph = curvature_graph(testing::arc_over_chord(alpha, 1.3, 3));
        ASSERT_TRUE(graph.line);
        EXPECT_NEAR(graph.line->slope, alpha, 1e-12);
        EXPECT_LT(graph.line->slope_error, 1e-12);
    }
    const Curve space = LogAestheticSpaceCurve({0.5, 0.8, 0.6}, {-2, 0.5, 0.7}, 2);
    EXPECT_NEAR(curvature_graph(space).line->slope, 0.5, 1e-11);
    EXPECT_NEAR(torsion_graph(space).line->slope, -2, 1e-11);
    EXPECT_THROW(torsion_graph(testing::arc_over_chord(1, 1, 2)), Error);
}

TEST(CurvatureGraph, OfACircleHasNoPoints) {
    const auto graph = curvature_graph(testing::arc_over_chord(0.5, 1, 1));
    EXPECT_TRUE(graph.points.empty());
    EXPECT_FALSE(graph.line);
}

TEST(Fairing, FindsAlphaWhereAsked) {
    const LogAestheticCurve arc = testing::arc_over_chord(0.5, std::numbers::pi / 2, 4);
    FairOptions options;
    options.alpha.value.reset();
    options.sigma = 1e-4;
    const Fairing made =
        fair(testing::with_noise(testing::points_on(arc, 100), 1e-4, 4, false), options);
    ASSERT_TRUE(made.report.alpha_error);
    EXPECT_NEAR(made.report.alpha, 0.5, 4 * *made.report.alpha_error);
    EXPECT_LT(*made.report.alpha_error, 0.03);
    options.sigma = 5e-3;
    const Fairing vague =
        fair(testing::with_noise(testing::points_on(arc, 100), 5e-3, 4, false), options);
    EXPECT_EQ(vague.report.alpha, -1);
    EXPECT_NE(vague.report.notes.back().find("not identifiable"), std::string::npos);
}

}  // namespace fair_alpha_test
}  // namespace batten
