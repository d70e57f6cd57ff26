#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "batten/base/error.hpp"
#include "batten/make/motion.hpp"
#include "batten/make/sample.hpp"
#include "curves.hpp"
#include "errors.hpp"

namespace batten {
namespace sample_bad_test {

using namespace batten::testing;

const Curve plane = bezier({0, 0, 1, 2, 3, 3, 4, 0});

SampleOptions by(Law law) {
    SampleOptions options;
    options.law = law;
    options.count = 5;
    return options;
}

std::string refusal(const SampleOptions& options) {
    return code_of([&] { sample(plane, options); });
}

TEST(ArcLengthMapRefuses, TolerancesThatAreNotPositiveAndPlacesOffTheCurve) {
    for (const double value : {0.0, -1.0, nan, inf}) {
        EXPECT_EQ(code_of([&] { ArcLengthMap(plane, relative(value)); }), "option.range");
        EXPECT_EQ(code_of([&] { ArcLengthMap(plane, absolute(value)); }), "option.range");
    }
    const ArcLengthMap map(plane);
    for (const double s : {-1e-9, 1.1 * map.length(), nan, inf}) {
        EXPECT_EQ(code_of([&] { map.t_of(s); }), "curve.outside");
        EXPECT_EQ(code_of([&] {
                      std::vector<double> many{0, s}, t(2);
                      map.t_of(many, t);
                  }),
                  "curve.outside");
    }
    EXPECT_EQ(code_of([&] { map.s_of(1.5); }), "curve.outside");
    EXPECT_EQ(code_of([&] { map.s_of(nan); }), "curve.outside");
}

TEST(ArcLengthMapRefuses, CurvesWithoutLength) {
    EXPECT_EQ(code_of([] { ArcLengthMap(bezier({2, 3, 2, 3, 2, 3, 2, 3})); }), "curve.no-length");
    EXPECT_EQ(code_of([] { sample(bezier({2, 3, 2, 3, 2, 3, 2, 3}), by(Law::constant)); }),
              "curve.no-length");
}

TEST(SampleRefuses, CountsThatAreMissingTwiceGivenOrTooLarge) {
    SampleOptions options;
    EXPECT_EQ(refusal(options), "option.missing");
    options.fps = 25;
    EXPECT_EQ(refusal(options), "option.missing") << "no duration";
    options.count = 5;
    EXPECT_EQ(refusal(options), "sample.options");
    options = {};
    options.spacing = 1e-12;
    EXPECT_EQ(refusal(options), "option.range");
    for (const int count : {1, 0, -4}) {
        options = {};
        options.count = count;
        EXPECT_EQ(refusal(options), "option.range") << count;
    }
    for (const double bad : {0.0, -1.0, nan, inf}) {
        options = {};
        options.spacing = bad;
        EXPECT_EQ(refusal(options), "option.range") << bad;
        options = by(Law::constant);
        options.duration = bad;
        EXPECT_EQ(refusal(options), "option.range") << bad;
    }
}

TEST(SampleRefuses, WeightsThatAreNone) {
    SampleOptions steps;
    steps.law = Law::relative;
    EXPECT_EQ(refusal(steps), "option.missing");
    for (const Points& bad : {Points({1, -1, 2}, 1), Points({0, 0}, 1), Points({1, nan}, 1),
                              Points({1, inf}, 1)}) {
        steps.weights = bad;
        EXPECT_EQ(refusal(steps), "motion.weights");
    }
    steps.weights = Points({0, 1, 2, 3}, 2);
    EXPECT_EQ(refusal(steps), "sample.options");
    steps.weights = Points({1, 1}, 1);
    steps.count = 9;
    EXPECT_EQ(refusal(steps), "sample.options");

    SampleOptions size = by(Law::weight);
    EXPECT_EQ(refusal(size), "option.missing");
    const double length = ArcLengthMap(plane).length();
    for (const Points& bad :
         {Points({0, 1}, 2), Points({0, 1, length, -1}, 2), Points({0, 1, length, nan}, 2),
          Points({0, 1, 0, 1}, 2), Points({0, 1, length / 2, 1}, 2), Points({1, 2, 3}, 1),
          Points({0.5, 1, length, 1}, 2)}) {
        size.weights = bad;
        EXPECT_EQ(refusal(size), "motion.weights");
    }
    size.weights = Points({0, 0, length, 0}, 2);
    EXPECT_EQ(refusal(size), "motion.no-weight");
}

TEST(SampleRefuses, PositionsAndKeysOffTheCurveOrFalling) {
    SampleOptions options;
    options.law = Law::positions;
    EXPECT_EQ(refusal(options), "option.missing");
    using List = std::vector<Tolerance>;
    for (const List& bad : {List{relative(0)}, List{relative(0), relative(1.1)},
                            List{absolute(-1), absolute(1)}, List{absolute(0), absolute(100)},
                            List{relative(0.5), relative(0.2)}, List{relative(0), relative(nan)}}) {
        options.positions = bad;
        EXPECT_EQ(refusal(options), "motion.positions");
    }
    SampleOptions keys = by(Law::keyframes);
    EXPECT_EQ(refusal(keys), "option.missing");
    for (const Points& bad :
         {Points({0, 0}, 2), Points({0, 0, 0, 1}, 2), Points({0, 0, 1, 100}, 2),
          Points({0, 1, 1, 0}, 2), Points({0, 0, nan, 1}, 2), Points({0, 1, 2}, 1)}) {
        keys.keys = bad;
        EXPECT_EQ(refusal(keys), "motion.keys");
    }
}

TEST(SampleRefuses, LawsWithoutWhatTheyNeed) {
    EXPECT_EQ(refusal(by(Law::curvature)), "option.missing");
    EXPECT_EQ(refusal(by(Law::time_optimal)), "option.missing");
    SampleOptions fastest = by(Law::time_optimal);
    fastest.max_speed = fastest.max_lateral = fastest.max_tangential = 1;
    fastest.duration = 4;
    EXPECT_EQ(refusal(fastest), "sample.options");
    fastest.duration.reset();
    for (const double bad : {0.0, -1.0, nan, inf}) {
        fastest.max_lateral = bad;
        EXPECT_EQ(refusal(fastest), "option.range");
    }
    SampleOptions trapezoid = by(Law::trapezoid);
    for (const double bad : {0.0, 0.6, -0.1, nan}) {
        trapezoid.ramp = bad;
        EXPECT_EQ(refusal(trapezoid), "option.range");
    }
    SampleOptions jerk = by(Law::s_curve);
    jerk.jerk_time = 0.3;
    EXPECT_EQ(refusal(jerk), "option.range");
    SampleOptions speeds = by(Law::accelerate);
    speeds.start_speed = speeds.end_speed = 0;
    EXPECT_EQ(refusal(speeds), "motion.speeds");
    speeds.start_speed = -1;
    EXPECT_EQ(refusal(speeds), "option.range");
    EXPECT_EQ(code_of([] { MotionLaw::accelerate(-1, 2); }), "motion.speeds");
}

TEST(SampleRefuses, OptionsThatContradictOneAnother) {
    SampleOptions options = by(Law::constant);
    options.between = 3;
    EXPECT_EQ(refusal(options), "sample.options");
    options = by(Law::chord);
    options.curvature_weight = 3;
    EXPECT_EQ(refusal(options), "sample.options");
    options = by(Law::constant);
    options.frames = true;
    EXPECT_EQ(refusal(options), "curve.dimension");
    options = by(Law::constant);
    options.curvature_weight = -1;
    EXPECT_EQ(refusal(options), "option.range");
    options = by(Law::constant);
    options.method = SampleMethod::harada_nakamae;
    EXPECT_EQ(refusal(options), "sample.options");
}

TEST(SampleRefuses, AProxyOfCurvatureOnAStraightLine) {
    EXPECT_EQ(code_of([] { sample(polyline(Points({0, 0, 1, 0}, 2)), by(Law::curvature_proxy)); }),
              "motion.no-weight");
}

TEST(MotionLawRefuses, LawsThatDoNotStartAt0OrEndAt1) {
    EXPECT_EQ(code_of([] { MotionLaw([](double tau) { return MotionState{0.9 * tau, 0.9}; }); }),
              "motion.law-ends");
    EXPECT_EQ(code_of([] { MotionLaw([](double tau) { return MotionState{0.1 + 0.9 * tau, 0.9}; }); }),
              "motion.law-ends");
    EXPECT_EQ(code_of([] { MotionLaw([](double) { return MotionState{nan, 0}; }); }),
              "motion.law-ends");
    EXPECT_EQ(code_of([] { Motion(plane, MotionLaw::constant(), 0); }), "option.range");
}

TEST(PaperMethodRefuses, WhatItCannotWalk) {
    SampleOptions options = by(Law::constant);
    options.method = SampleMethod::harada_nakamae;
    const auto refused = [&](const Points& points) {
        return code_of([&] { sample_harada_nakamae(points, options); });
    };
    EXPECT_EQ(refused(Points({0, 0}, 2)), "points.too-few");
    EXPECT_EQ(refused(Points({0, 0, 0, 1, 1, 1}, 3)), "points.dimension");
    EXPECT_EQ(refused(Points({0, 0, 0, 0, 1, 1}, 2)), "points.repeated");
    EXPECT_EQ(refused(Points({0, 0, nan, 0, 1, 1}, 2)), "points.not-finite");
    options.law = Law::chord;
    EXPECT_EQ(refused(Points({0, 0, 1, 0, 1, 1}, 2)), "sample.options");
}

TEST(SampleRefuses, OptionsOfAnotherLaw) {
    const auto with = [](auto change) {
        SampleOptions options = by(Law::constant);
        change(options);
        return refusal(options);
    };
    EXPECT_EQ(with([](SampleOptions& o) { o.positions = {absolute(0), absolute(1)}; }),
              "sample.options");
    EXPECT_EQ(with([](SampleOptions& o) { o.keys = Points({0, 0, 1, 1}, 2); }), "sample.options");
    EXPECT_EQ(with([](SampleOptions& o) { o.ramp = 0.3; }), "sample.options");
    EXPECT_EQ(with([](SampleOptions& o) { o.accel_time = 0.3; }), "sample.options");
    EXPECT_EQ(with([](SampleOptions& o) { o.jerk_time = 0.2; }), "sample.options");
    EXPECT_EQ(with([](SampleOptions& o) { o.start_speed = 1; }), "sample.options");
    EXPECT_EQ(with([](SampleOptions& o) { o.end_speed = 1; }), "sample.options");
    EXPECT_EQ(with([](SampleOptions& o) { o.max_speed = 1; }), "sample.options");
    EXPECT_EQ(with([](SampleOptions& o) { o.max_lateral = 1; }), "sample.options");
    EXPECT_EQ(with([](SampleOptions& o) { o.max_tangential = 1; }), "sample.options");
    EXPECT_EQ(with([](SampleOptions& o) { o.walked_length = WalkedLength::polyline; }),
              "sample.options");
}

}  // namespace sample_bad_test
}  // namespace batten
