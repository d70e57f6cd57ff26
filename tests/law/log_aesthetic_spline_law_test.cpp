#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "batten/make/interpolate.hpp"
#include "batten/shape/log_aesthetic.hpp"
#include "random.hpp"

namespace batten {
namespace log_aesthetic_spline_law_test {

InterpolateOptions with_alpha(double alpha, bool closed = false) {
    InterpolateOptions options;
    options.method = Method::log_aesthetic;
    options.alpha = alpha;
    options.closed = closed;
    return options;
}

LogAestheticCurve arcs_through(PointsView points, const InterpolateOptions& options) {
    return *curve_through(points, options).shape<LogAestheticCurve>();
}

/// The jump of the curvature where arc i begins, times the shorter arc beside it.
double jump_at(const LogAestheticCurve& curve, std::size_t i) {
    const auto arcs = curve.segments();
    const LogAestheticSegment &a = arcs[(i + arcs.size() - 1) % arcs.size()], &b = arcs[i];
    return std::fabs(b.start_curvature - a.end_curvature) * std::fmin(a.length, b.length);
}

/// How far the direction of arc i differs from that in which the one before it ends.
double kink_at(const LogAestheticCurve& curve, std::size_t i) {
    const std::size_t before = (i + curve.segments().size() - 1) % curve.segments().size();
    const double arriving = curve.angles()[before] + curve.segments()[before].turn();
    return std::fabs(std::remainder(curve.angles()[i] - arriving, 2 * std::numbers::pi));
}

TEST(LogAestheticSplines, AreMadeOfTenThousandRandomSets) {
    testing::Random random(1);
    int smooth = 0, held = 0;
    for (int k = 0; k < 10000; ++k) {
        const bool closed = random.within(0, 1) < 0.4;
        const Points points =
            random.points(static_cast<std::size_t>(random.whole(closed ? 3 : 2, 14)), 2);
        const Curve curve = curve_through(points, with_alpha(-1, closed));
        const auto& arcs = *curve.shape<LogAestheticCurve>();
        double jump = 0, kink = 0, miss = 0, longest = 0;
        for (std::size_t i = 0; i < arcs.segments().size(); ++i) {
            miss = std::fmax(miss, arcs.miss(i));
            longest = std::fmax(longest, arcs.segments()[i].length);
            if (i == 0 && !closed) continue;
            jump = std::fmax(jump, jump_at(arcs, i));
            kink = std::fmax(kink, kink_at(arcs, i));
        }
        EXPECT_LT(kink, 1e-10) << k;
        EXPECT_LT(miss, 1e-10) << k;
        EXPECT_LT(longest, 70) << k;  // 25 chords
        (jump < 1e-9 ? smooth : held) += 1;
    }
    // The others have a point where only a loop would be G2: there the curvature jumps.
    EXPECT_GT(smooth, 6000);
    EXPECT_EQ(smooth + held, 10000);
}

TEST(LogAestheticSplines, SayWhereTheCurvatureJumps) {
    testing::Random random(2);
    int met = 0, not_met = 0;
    for (int k = 0; k < 20; ++k) {
        const Points points = random.points(8, 2);
        const Interpolation made = interpolate(points, with_alpha(-1));
        const auto& arcs = *made.curve.shape<LogAestheticCurve>();
        double jump = 0;
        for (std::size_t i = 1; i < arcs.segments().size(); ++i) {
            jump = std::fmax(jump, jump_at(arcs, i));
        }
        EXPECT_EQ(made.report.status, jump < 1e-9 ? Status::met : Status::not_met) << k;
        EXPECT_EQ(made.report.notes.empty(), jump < 1e-9) << k;
        (made.report.status == Status::met ? met : not_met) += 1;
    }
    EXPECT_GT(met, 8);
    EXPECT_GT(not_met, 1);
}

TEST(LogAestheticSplines, OfAnyAlphaHaveContinuousCurvature) {
    Points wave(0, 2);
    for (int i = 0; i < 20; ++i) {
        const double t = 0.5 * i + 0.1 * std::sin(7.0 * i);
        wave.push_back(std::vector<double>{t, std::sin(t) + 0.1 * t * t});
    }
    for (const double alpha : {-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0}) {
        const Interpolation made = interpolate(wave, with_alpha(alpha));
        EXPECT_EQ(made.report.status, Status::met) << alpha;
        const auto& arcs = *made.curve.shape<LogAestheticCurve>();
        std::size_t of_alpha = 0;
        for (std::size_t i = 0; i < arcs.segments().size(); ++i) {
            of_alpha += arcs.segments()[i].alpha == alpha;
            EXPECT_LT(arcs.miss(i), 1e-9);
            if (i > 0) {
                EXPECT_LT(jump_at(arcs, i), 1e-9) << alpha;
            }
        }
        EXPECT_GT(of_alpha, 0u) << alpha;
        EXPECT_NEAR(arcs.segments().front().start_curvature, 0, 1e-12);
    }
}

TEST(LogAestheticSplines, ThroughPointsOfACircleAreTheCircle) {
    Points points(0, 2);
    for (const double angle : {0.0, 0.3, 1.5, 1.6, 3.0, 5.0}) {
        points.push_back(std::vector<double>{2 * std::cos(angle), 2 * std::sin(angle)});
    }
    for (const double alpha : {-1.0, 0.5, 2.0}) {
        const LogAestheticCurve curve = arcs_through(points, with_alpha(alpha, true));
        for (const LogAestheticSegment& s : curve.segments()) {
            EXPECT_NEAR(s.start_curvature, 0.5, 1e-10);
            EXPECT_NEAR(s.end_curvature, 0.5, 1e-10);
        }
    }
}

TEST(LogAestheticSplines, ScaleExactly) {
    testing::Random random(3);
    for (int k = 0; k < 40; ++k) {
        const Points points = random.points(7, 2);
        Points large(points);
        for (double& x : large.coordinates()) x *= 1024;
        const double alpha = k % 2 == 0 ? -1 : 0.5;
        const auto a = arcs_through(points, with_alpha(alpha, k % 3 == 0));
        const auto b = arcs_through(large, with_alpha(alpha, k % 3 == 0));
        for (std::size_t i = 0; i < a.segments().size(); ++i) {
            EXPECT_EQ(b.segments()[i].length, 1024 * a.segments()[i].length);
            EXPECT_EQ(b.segments()[i].start_curvature, a.segments()[i].start_curvature / 1024);
            EXPECT_EQ(b.angles()[i], a.angles()[i]);
        }
    }
}

TEST(LogAestheticSplines, TakeCornersAndTangents) {
    const Points square({0, 0, 4, 0.5, 8, 0, 8, 5, 4, 7, 0, 5}, 2);
    InterpolateOptions options = with_alpha(-1, true);
    options.corner = {2};
    options.tangent = {{4, {std::numbers::pi}}};
    const Interpolation made = interpolate(square, options);
    EXPECT_EQ(made.report.status, Status::met);
    const auto& arcs = *made.curve.shape<LogAestheticCurve>();
    EXPECT_GT(kink_at(arcs, 2), 0.5);
    EXPECT_NEAR(arcs.segments()[1].end_curvature, 0, 1e-10);
    EXPECT_NEAR(arcs.segments()[2].start_curvature, 0, 1e-10);
    EXPECT_NEAR(std::fabs((*made.report.tangent_angles)[4]), std::numbers::pi, 1e-12);
    for (const std::size_t i : {0, 1, 3, 5}) EXPECT_LT(jump_at(arcs, i), 1e-9) << i;
    options.part = IndexRange{1, 3};
    const Interpolation part = interpolate(square, options);
    EXPECT_EQ(part.curve.shape<LogAestheticCurve>()->segments()[0], arcs.segments()[1]);
    EXPECT_EQ(part.curve.domain().lo, 0);
}

}  // namespace log_aesthetic_spline_law_test
}  // namespace batten
