#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "make/pseudo/global/angles.hpp"
#include "make/pseudo/local_angles.hpp"
#include "make/pseudo/segment/angles.hpp"
#include "random.hpp"

namespace batten::pseudo {
namespace pseudo_spline_angles_law_test {

using batten::testing::Random;

constexpr double pi = std::numbers::pi;

/// Points that wander to the right; no two neighbours meet.
Points wandering(Random& random, std::size_t count) {
    Points points(count, 2);
    for (std::size_t i = 0; i < count; ++i) {
        points(i, 0) = static_cast<double>(i) + random.within(-0.7, 0.7);
        points(i, 1) = random.within(-1.5, 1.5);
    }
    return points;
}

Points scaled(const Points& points, double factor) {
    Points result = points;
    for (double& x : result.coordinates()) x *= factor;
    return result;
}

TEST(LocalAngles, ScaleByPowersOfTwoExactly) {
    Random random(1);
    AngleRules rules;
    for (const double p : {1.0, -1.0, 0.37}) {
        rules.weight_exponent = p;
        const Points points = wandering(random, 8);
        const auto spans = local_angles(points, rules);
        const auto big = local_angles(scaled(points, 0x1p40), rules);
        for (std::size_t i = 0; i < spans.size(); ++i) {
            EXPECT_EQ(big[i].theta0, spans[i].theta0);
            EXPECT_EQ(big[i].theta1, spans[i].theta1);
            EXPECT_EQ(big[i].length, 0x1p40 * spans[i].length);
            EXPECT_EQ(big[i].direction, spans[i].direction);
        }
    }
}

TEST(LocalAngles, OfMirroredPointsAreMirroredExactly) {
    Random random(2);
    const Points points = wandering(random, 9);
    Points mirrored = points;
    for (std::size_t i = 0; i < points.size(); ++i) mirrored(i, 1) = -points(i, 1);
    const auto spans = local_angles(points, {});
    const auto images = local_angles(mirrored, {});
    for (std::size_t i = 0; i < spans.size(); ++i) {
        EXPECT_EQ(images[i].theta0, -spans[i].theta0);
        EXPECT_EQ(images[i].theta1, -spans[i].theta1);
    }
}

TEST(LocalAngles, OfReversedPointsAreReversed) {
    Random random(3);
    const Points points = wandering(random, 9);
    Points reversed(0, 2);
    for (std::size_t i = points.size(); i-- > 0;) reversed.push_back(points[i]);
    const auto spans = local_angles(points, {});
    const auto back = local_angles(reversed, {});
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const SpanAngles& other = back[spans.size() - 1 - i];
        EXPECT_NEAR(other.theta0, spans[i].theta1, 1e-13);
        EXPECT_NEAR(other.theta1, spans[i].theta0, 1e-13);
    }
}

TEST(LocalAngles, OfTurnedPointsAreTheSame) {
    Random random(4);
    const Points points = wandering(random, 8);
    Points turned = points;
    const double c = std::cos(2.2), s = std::sin(2.2);
    for (std::size_t i = 0; i < points.size(); ++i) {
        turned(i, 0) = c * points(i, 0) - s * points(i, 1);
        turned(i, 1) = s * points(i, 0) + c * points(i, 1);
    }
    const auto spans = local_angles(points, {});
    const auto others = local_angles(turned, {});
    for (std::size_t i = 0; i < spans.size(); ++i) {
        EXPECT_NEAR(others[i].theta0, spans[i].theta0, 1e-12);
        EXPECT_NEAR(wrap(others[i].start_tangent() - spans[i].start_tangent() - 2.2), 0, 1e-12);
    }
}

TEST(LocalAngles, DependOnNeighboursAlone) {
    Random random(5);
    const Points points = wandering(random, 12);
    const auto before = local_angles(points, {});
    Points moved = points;
    moved(6, 1) += 0.3;
    const auto after = local_angles(moved, {});
    for (std::size_t i = 0; i < before.size(); ++i) {
        // Tangents change at points 5, 6, 7, chords between them: spans 4 ... 7.
        const bool may_change = i >= 4 && i <= 7;
        EXPECT_EQ(after[i].theta0 != before[i].theta0 || after[i].theta1 != before[i].theta1,
                  may_change)
            << i;
    }
}

TEST(LocalAngles, OfAClosedRegularPolygonAreAllEqual) {
    AngleRules rules;
    rules.is_closed = true;
    const Points square({0, 0, 2, 0, 2, 2, 0, 2}, 2);
    for (const SpanAngles& span : local_angles(square, rules)) {
        EXPECT_EQ(span.theta0, -pi / 4);
        EXPECT_EQ(span.theta1, pi / 4);
    }
}

TEST(LocalAngles, FoldBackToOneSideAndStayFinite) {
    const Points points({0, 0, 3, 0, 1, 0, 2, 0}, 2);
    for (const SpanAngles& span : local_angles(points, {})) {
        EXPECT_TRUE(std::isfinite(span.theta0) && std::isfinite(span.theta1));
        EXPECT_NE(span.theta0, 0);
    }
}

TEST(Corners, MakeTwoCurvesOfOne) {
    Random random(6);
    const Points points = wandering(random, 9);
    AngleRules rules;
    rules.corners = {4};
    const auto spans = local_angles(points, rules);
    const auto first = local_angles(points.view().part(0, 5), {});
    const auto second = local_angles(points.view().part(4, 5), {});
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(spans[i].theta0, first[i].theta0);
        EXPECT_EQ(spans[i].theta1, first[i].theta1);
        EXPECT_EQ(spans[i + 4].theta0, second[i].theta0);
        EXPECT_EQ(spans[i + 4].theta1, second[i].theta1);
    }
}

TEST(Corners, AtBothEndsMakeAStraightSpan) {
    const Points points({0, 0, 1, 1, 2, 0, 3, 1}, 2);
    AngleRules rules;
    rules.corners = {1, 2};
    const auto spans = local_angles(points, rules);
    for (const SpanAngles& span : spans) {
        EXPECT_EQ(span.theta0, 0);
        EXPECT_EQ(span.theta1, 0);
    }
}

TEST(FixedTangents, AreKept) {
    const Points points({0, 0, 1, 1, 2, 0, 3, 1, 4, 0}, 2);
    AngleRules rules;
    rules.tangents = {{0, {0.5}}, {2, {-7.0}}};
    for (const auto& spans : {local_angles(points, rules), global_angles(points, rules).spans}) {
        EXPECT_NEAR(wrap(spans[0].start_tangent() - 0.5), 0, 1e-15);
        EXPECT_NEAR(wrap(spans[1].end_tangent() + 7), 0, 2e-15);
        EXPECT_NEAR(wrap(spans[2].start_tangent() + 7), 0, 2e-15);
    }
}

TEST(GlobalAngles, AreNeverHigherThanTheLocalOnesAndJoinSmoothly) {
    Random random(7);
    for (const bool is_closed : {false, true}) {
        const Points points = wandering(random, 7);
        AngleRules rules;
        rules.is_closed = is_closed;
        const GlobalSpline spline = global_angles(points, rules);
        EXPECT_EQ(spline.status, GlobalStatus::converged);
        EXPECT_LT(spline.gradient, 1e-11 * spline.energy);
        double local = 0;
        for (const SpanAngles& span : local_angles(points, rules)) {
            local += span.length * least_minimum(span.theta0, span.theta1).pseudo_energy;
        }
        EXPECT_LT(spline.energy, local);
        const std::size_t n = spline.spans.size();
        for (std::size_t i = is_closed ? 0 : 1; i < n; ++i) {
            const SpanAngles& before = spline.spans[(i + n - 1) % n];
            EXPECT_NEAR(wrap(spline.spans[i].start_tangent() - before.end_tangent()), 0, 1e-14);
        }
    }
}

TEST(GlobalAngles, OfACornerAreThoseOfTwoCurves) {
    Random random(8);
    const Points points = wandering(random, 7);
    AngleRules rules;
    rules.corners = {3};
    const double together = global_angles(points, rules).energy;
    const double first = global_angles(points.view().part(0, 4), {}).energy;
    const double second = global_angles(points.view().part(3, 4), {}).energy;
    EXPECT_NEAR(together, first + second, 1e-10 * together);
}

TEST(GlobalAngles, ScaleByPowersOfTwoExactly) {
    Random random(9);
    const Points points = wandering(random, 6);
    AngleRules rules;
    rules.weight_exponent = 0.7;
    const GlobalSpline spline = global_angles(points, rules);
    const GlobalSpline small = global_angles(scaled(points, 0x1p-30), rules);
    EXPECT_EQ(small.steps, spline.steps);
    for (std::size_t i = 0; i < spline.spans.size(); ++i) {
        EXPECT_EQ(small.spans[i].theta0, spline.spans[i].theta0);
        EXPECT_EQ(small.minima[i].segment.r0, spline.minima[i].segment.r0);
    }
}

}  // namespace pseudo_spline_angles_law_test
}  // namespace batten::pseudo
