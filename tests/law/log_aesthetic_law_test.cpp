#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "batten/make/convert.hpp"
#include "batten/make/log_aesthetic.hpp"
#include "batten/measure/continuity.hpp"
#include "batten/measure/length.hpp"
#include "batten/shape/log_aesthetic_space.hpp"
#include "random.hpp"

namespace batten {
namespace log_aesthetic_law_test {

/// A random segment that is drawable, of a random alpha.
LogAestheticSegment any_segment(testing::Random& random) {
    while (true) {
        const double alpha = random.within(-3, 4), turn = random.within(0.1, 2.8);
        const auto arc =
            log_aesthetic_segment(alpha, random.within(0.1, 10), random.within(0, turn), turn);
        if (arc && std::fabs(arc->log_radius_ratio()) < 6) return *arc;
    }
}

TEST(LogAestheticSegments, MeetTheirEndTangents) {
    testing::Random random(1);
    int drawn = 0;
    for (int i = 0; i < 400; ++i) {
        const double alpha = random.within(-4, 5), turn = random.within(0.05, 2.9);
        const double chord_angle = random.within(0, turn);
        const auto arc = log_aesthetic_segment(alpha, 1, chord_angle, turn);
        if (!arc) continue;
        ++drawn;
        const LogAestheticCurve curve(std::vector<double>{0, 0}, -chord_angle, *arc);
        EXPECT_NEAR(arc->turn(), turn, 1e-13) << alpha;
        EXPECT_NEAR(curve.joints()(1, 0), 1, 1e-12) << alpha;
        EXPECT_NEAR(curve.joints()(1, 1), 0, 1e-12) << alpha;
    }
    EXPECT_GT(drawn, 150);
}

TEST(LogAestheticArcs, HaveTheDerivativesOfTheirValues) {
    testing::Random random(2);
    for (int i = 0; i < 40; ++i) {
        const LogAestheticSegment arc = any_segment(random);
        const LogAestheticCurve shape(std::vector<double>{1, 2}, 0.4, arc);
        const Curve curve = shape;
        const double s = arc.length * random.within(0.2, 0.8), h = 1e-4 * arc.length;
        const Jet at = curve.jet(s, 4), before = curve.jet(s - h, 4), after = curve.jet(s + h, 4);
        for (int k = 1; k <= 4; ++k) {
            double size = 0;
            for (int j = k; j <= 4; ++j) {
                size += std::hypot(at[j][0], at[j][1]) * std::pow(arc.length, j - k);
            }
            for (std::size_t x = 0; x < 2; ++x) {
                const double slope = (after[k - 1][x] - before[k - 1][x]) / (2 * h);
                EXPECT_NEAR(at[k][x], slope, 1e-4 * size) << k;
            }
        }
        EXPECT_NEAR(std::hypot(at[1][0], at[1][1]), 1, 1e-15);
    }
}

TEST(LogAestheticArcs, HaveLinearPowersOfTheirRadius) {
    testing::Random random(3);
    for (int i = 0; i < 40; ++i) {
        const LogAestheticSegment arc = any_segment(random);
        const Curve curve = LogAestheticCurve(std::vector<double>{0, 0}, 0, arc);
        const auto power = [&](double share) {
            const Jet jet = curve.jet(share * arc.length, 2);
            const double kappa = jet[1][0] * jet[2][1] - jet[1][1] * jet[2][0];
            return std::pow(kappa / arc.start_curvature, -arc.alpha);
        };
        for (const double x : {0.2, 0.5, 0.9}) {
            EXPECT_NEAR(power(x), 1 + x * (power(1) - 1), 1e-12 * (1 + power(1)));
        }
    }
}

TEST(LogAestheticSegments, ScaleExactlyAndMirror) {
    testing::Random random(4);
    for (int i = 0; i < 50; ++i) {
        const double alpha = random.within(-3, 3), turn = random.within(0.1, 2.8);
        const double chord_angle = turn * random.within(0.3, 0.7);
        const auto arc = log_aesthetic_segment(alpha, 0.7, chord_angle, turn);
        const auto large = log_aesthetic_segment(alpha, 0.7 * 1024, chord_angle, turn);
        const auto right = log_aesthetic_segment(alpha, 0.7, -chord_angle, -turn);
        ASSERT_EQ(bool(arc), bool(large));
        if (!arc) continue;
        EXPECT_EQ(large->length, 1024 * arc->length);
        EXPECT_EQ(large->start_curvature, arc->start_curvature / 1024);
        EXPECT_EQ(right->length, arc->length);
        EXPECT_EQ(right->end_curvature, -arc->end_curvature);
    }
}

TEST(LogAestheticCurves, TurnIntoCubicsAndHaveTheirLength) {
    testing::Random random(5);
    for (int i = 0; i < 10; ++i) {
        const LogAestheticSegment arc = any_segment(random);
        const Curve curve = LogAestheticCurve(std::vector<double>{0, 0}, 0, arc);
        EXPECT_NEAR(length(curve).value, arc.length, 1e-12 * arc.length);
        ConvertOptions options;
        options.as = Form::cubic;
        options.tolerance = relative(1e-8);
        const Conversion made = convert(curve, options);
        EXPECT_EQ(made.report.status, Status::met);
        EXPECT_LT(made.report.max_error, 1e-8 * extent(curve));
    }
}

TEST(LogAestheticCurves, TurnIntoFewerQuinticsThanCubics) {
    testing::Random random(6);
    for (int i = 0; i < 10; ++i) {
        const Curve curve =
            LogAestheticCurve(std::vector<double>{0, 0}, 0, any_segment(random));
        ConvertOptions options;
        options.tolerance = relative(1e-9);
        options.as = Form::cubic;
        const std::size_t cubics = convert(curve, options).report.pieces;
        options.as = Form::quintic;
        const Conversion made = convert(curve, options);
        EXPECT_EQ(made.report.status, Status::met);
        EXPECT_LT(made.report.max_error, 1e-9 * extent(curve));
        EXPECT_LE(made.report.pieces, cubics);
        EXPECT_EQ(made.curve.degree(), 5);
        for (const Joint& joint : continuity(made.curve)) EXPECT_EQ(joint.continuity, Continuity::C2);
    }
}

TEST(LogAestheticSpaceCurves, HaveTheDerivativesOfTheirValues) {
    const Curve curve = LogAestheticSpaceCurve({0.5, 0.8, 0.6}, {-1, 0.5, 0.7}, 2);
    const double s = 0.9, h = 1e-4;
    const Jet at = curve.jet(s, 4), before = curve.jet(s - h, 4), after = curve.jet(s + h, 4);
    for (int k = 1; k <= 4; ++k) {
        for (std::size_t x = 0; x < 3; ++x) {
            EXPECT_NEAR(at[k][x], (after[k - 1][x] - before[k - 1][x]) / (2 * h), 1e-6) << k;
        }
    }
}

}  // namespace log_aesthetic_law_test
}  // namespace batten
