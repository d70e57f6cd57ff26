#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "batten/make/motion.hpp"
#include "batten/make/sample.hpp"
#include "curves.hpp"
#include "figure_8.hpp"
#include "shared_json.hpp"

namespace batten {
namespace motion_known_test {

using namespace batten::testing;

const char* const reference = "reference/sampling/motion_reference.json";

SampleOptions by(Law law, int count = 13) {
    SampleOptions options;
    options.law = law;
    options.count = count;
    return options;
}

/// Every sample of the reference: s, x, y (and time) to `tolerance`.
void expect_reference(const char* name, const SampleOptions& options, double tolerance = 1e-10) {
    const auto law = shared_json(reference)["laws"][name];
    const Sampling made = sample(figure_8(), options);
    ASSERT_EQ(made.rows.size(), law["samples"].size()) << name;
    for (std::size_t i = 0; i < made.rows.size(); ++i) {
        const auto& wanted = law["samples"][i];
        if (options.law != Law::relative) {  // there the reference counts in weights
            EXPECT_NEAR(made.rows(i, 1), wanted["tau"].get<double>(), 1e-15) << name << i;
        }
        EXPECT_NEAR(made.rows(i, 2), wanted["s"].get<double>(), tolerance) << name << i;
        EXPECT_NEAR(made.rows(i, 4), wanted["x"].get<double>(), tolerance) << name << i;
        EXPECT_NEAR(made.rows(i, 5), wanted["y"].get<double>(), tolerance) << name << i;
        if (wanted.contains("kappa")) {
            EXPECT_NEAR(made.rows(i, 8), wanted["kappa"].get<double>(), 1e-12) << name << i;
        }
    }
}

TEST(Motion, OfEveryClosedFormLawIsThatOfTheReference) {
    SKIP_UNLESS_SHARED(reference);
    expect_reference("constant_speed", by(Law::constant));
    expect_reference("constant_acceleration_from_rest", by(Law::accelerate));
    expect_reference("constant_deceleration_to_rest", by(Law::decelerate));
    expect_reference("smoothstep", by(Law::smoothstep));
    expect_reference("smootherstep_min_jerk", by(Law::minimum_jerk));
    expect_reference("cosine_ease", by(Law::cosine));
    expect_reference("trapezoid_0.25", by(Law::trapezoid));
    expect_reference("s_curve_7phase_Ta0.4_Tj0.1", by(Law::s_curve));
    SampleOptions ratio = by(Law::accelerate);
    ratio.start_speed = 1;
    ratio.end_speed = 3;
    expect_reference("constant_acceleration_v0_v1_ratio3", ratio);
}

TEST(Motion, ByStepsPositionsAndWeightsIsThatOfTheReference) {
    SKIP_UNLESS_SHARED(reference);
    SampleOptions steps;
    steps.law = Law::relative;
    steps.weights = Points({1, 2, 3, 1, 1, 4}, 1);
    expect_reference("relative_distances_1_2_3_1_1_4", steps);

    const auto all = shared_json(reference);
    const auto& rows = all["laws"]["explicit_positions"]["samples"];
    SampleOptions positions;
    positions.law = Law::positions;
    for (const auto& row : rows) positions.positions.push_back(absolute(row["s"].get<double>()));
    const Sampling made = sample(figure_8(), positions);
    ASSERT_EQ(made.rows.size(), rows.size());
    for (std::size_t i = 0; i < made.rows.size(); ++i) {
        EXPECT_NEAR(made.rows(i, 2), rows[i]["s"].get<double>(), 1e-10);
        EXPECT_NEAR(made.rows(i, 4), rows[i]["x"].get<double>(), 1e-10);
        EXPECT_NEAR(made.rows(i, 5), rows[i]["y"].get<double>(), 1e-10);
    }

    SampleOptions size = by(Law::weight);
    size.weights = Points({0, 1, ArcLengthMap(figure_8()).length(), 4}, 2);
    expect_reference("object_size_weight_1+3s/L", size);

    SampleOptions bends = by(Law::curvature);
    bends.curvature_weight = 20;
    expect_reference("curvature_weight_1+20kappa", bends);
}

TEST(MotionLaw, ByWeightsSpendsTimeInProportion) {
    const MotionLaw law = MotionLaw::weighted(Points({0, 1, 1, 4}, 2));
    for (int i = 0; i <= 10; ++i) {
        const double q = 0.25 * i, share = 2 * q / (1 + std::sqrt(1 + 6 * q));
        EXPECT_NEAR(law.at(0.1 * i).share, share, 1e-15);
        EXPECT_NEAR(law.at(0.1 * i).speed, 2.5 / (1 + 3 * share), 1e-14);
    }
    const MotionLaw hold = MotionLaw::weighted(Points({0, 0, 0.5, 2, 1, 0}, 2));
    EXPECT_NEAR(hold.at(0.5).share, 0.5, 1e-15);
    EXPECT_NEAR(hold.at(0.125).share, 0.25, 1e-15);
}

void expect_time_optimal(const char* name, const MotionLimits& limits, double duration) {
    const auto law = shared_json(reference)["laws"][name];
    const Curve curve = figure_8();
    const ArcLengthMap map(curve);
    const TimedLaw fastest = time_optimal_law(curve, map, limits);
    EXPECT_NEAR(fastest.duration, duration, 1e-8) << name;
    for (const auto& row : law["samples"]) {
        // When the law is at the row's place.
        const double share = row["s_over_L"].get<double>();
        double lo = 0, hi = 1;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (lo + hi);
            (fastest.law.at(middle).share < share ? lo : hi) = middle;
        }
        const double time = share == 1 ? fastest.duration : lo * fastest.duration;
        EXPECT_NEAR(time, row["time"].get<double>(), 1e-8) << name << share;
        const double v = fastest.law.at(lo).speed * map.length() / fastest.duration;
        if (share > 0 && share < 1) {
            EXPECT_NEAR(v, row["v"].get<double>(), 5e-8) << name << share;
        }
    }
}

TEST(TimeOptimal, TakesTheTimesOfTheReference) {
    SKIP_UNLESS_SHARED(reference);
    expect_time_optimal("time_optimal", {60, 100, 80}, 9.54750476);
    expect_time_optimal("time_optimal_tight", {60, 40, 30}, 13.32558185);
}

TEST(TimeOptimal, OnACircleIsTheClosedForm) {
    const Curve circle = ellipse(25, 25);
    const TimedLaw fastest = time_optimal_law(circle, ArcLengthMap(circle), {60, 100, 80});
    EXPECT_NEAR(fastest.duration, 3.766592653589793, 1e-9);
    const MotionState middle = fastest.law.at(0.5);
    EXPECT_NEAR(middle.share, 0.5, 1e-12);
    EXPECT_NEAR(middle.speed * 50 * std::numbers::pi / fastest.duration, 50, 1e-9);
}

TEST(TimeOptimal, OnALineSpeedsUpAndSlowsDownEvenly) {
    const Curve line = polyline(Points({0, 0, 100, 0}, 2));
    const TimedLaw fastest = time_optimal_law(line, ArcLengthMap(line), {1000, 1, 4});
    EXPECT_NEAR(fastest.duration, 10, 1e-12);  // 100 = 2 (4 t^2 / 2), t = 5 each way
    EXPECT_NEAR(fastest.law.at(0.25).share, 0.125, 1e-12);
}

TEST(Keyframes, RestWhereTwoKeysAreAtOnePlaceAndMeetTheirTimes) {
    const Curve line = polyline(Points({0, 0, 10, 0}, 2));
    SampleOptions options;
    options.law = Law::keyframes;
    options.keys = Points({2, 0, 3, 4, 5, 4, 6, 10}, 2);
    options.fps = 2;
    const Sampling made = sample(line, options);
    ASSERT_EQ(made.rows.size(), 9U);
    EXPECT_EQ(made.report.duration, 4);
    EXPECT_EQ(made.rows(0, 1), 2);
    EXPECT_EQ(made.rows(8, 1), 6);
    for (const std::size_t held : {2U, 3U, 4U, 5U, 6U}) {
        EXPECT_NEAR(made.rows(held, 2), 4, 1e-14) << held;
        EXPECT_NEAR(made.rows(held, 9), 0, 1e-14) << held;
    }
    EXPECT_EQ(made.rows(8, 4), 10);
}

TEST(Motion, KnowsPlaceAndVelocityAtAnyTime) {
    const Curve circle = ellipse(2, 2);
    const Motion motion(circle, MotionLaw::smoothstep(), 10);
    const double angle = 2 * std::numbers::pi * (3 * 0.09 - 2 * 0.027);
    EXPECT_NEAR(motion.position(3)[0], 2 * std::cos(angle), 1e-12);
    EXPECT_NEAR(motion.position(3)[1], 2 * std::sin(angle), 1e-12);
    const double v = 4 * std::numbers::pi * 6 * 0.3 * 0.7 / 10;
    EXPECT_NEAR(motion.velocity(3)[0], -v * std::sin(angle), 1e-11);
    EXPECT_NEAR(motion.velocity(3)[1], v * std::cos(angle), 1e-11);
    EXPECT_EQ(motion.position(-1), motion.position(0));
    EXPECT_EQ(motion.position(99), motion.position(10));
}

TEST(Frames, OfAHelixTurnBackAgainstItsTorsion) {
    // Against the principal normal a frame that does not roll turns by -torsion s.
    const double radius = 3, slope = 4, s = 5;
    SampleOptions options = by(Law::constant, 5);
    options.frames = true;
    const Sampling made = sample(helix(radius, slope), options);
    const double torsion = slope / (radius * radius + slope * slope);
    const auto angle = [&](std::size_t i) {
        const double t = made.rows(i, 3);
        const double along = -made.rows(i, 12) * std::cos(t) - made.rows(i, 13) * std::sin(t);
        const double b[] = {slope / s * std::sin(t), -slope / s * std::cos(t), radius / s};
        double across = 0;
        for (int k = 0; k < 3; ++k) across += made.rows(i, 12 + k) * b[k];
        return std::atan2(across, along);
    };
    for (std::size_t i = 1; i < made.rows.size(); ++i) {
        EXPECT_NEAR(angle(i) - angle(0), -torsion * made.rows(i, 2), 1e-8) << i;
    }
}

TEST(TimeOptimal, StopsAtCorners) {
    const Curve corner = polyline(Points({0, 0, 1, 0, 1, 1}, 2));
    const TimedLaw fastest = time_optimal_law(corner, ArcLengthMap(corner), {1, 100, 1});
    EXPECT_EQ(fastest.corners, 1u);
    EXPECT_NEAR(fastest.duration, 4, 1e-12);  // twice: up to 1 in half of the way, and down again
    EXPECT_NEAR(fastest.law.at(0.5).share, 0.5, 1e-12);
    EXPECT_NEAR(fastest.law.at(0.5).speed, 0, 1e-6);
    EXPECT_NEAR(fastest.law.at(0.25).speed * 2 / fastest.duration, 1, 1e-12);
    SampleOptions options = by(Law::time_optimal);
    options.max_speed = options.max_tangential = 1;
    options.max_lateral = 100;
    const Sampling made = sample(corner, options);
    ASSERT_EQ(made.report.notes.size(), 1u);
    EXPECT_NE(made.report.notes[0].find("corners of the curve: 1"), std::string::npos);
    EXPECT_EQ(time_optimal_law(ellipse(2, 1), ArcLengthMap(ellipse(2, 1)), {1, 1, 1}).corners, 0u);
}

}  // namespace motion_known_test
}  // namespace batten
