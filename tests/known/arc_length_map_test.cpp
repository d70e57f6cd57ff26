#include "batten/measure/arc_length_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "batten/measure/length.hpp"
#include "curves.hpp"
#include "shared_json.hpp"

namespace batten {
namespace arc_length_map_test {

using namespace batten::testing;

/// The arc length from the start to t by another way: adaptive Gauss-Legendre over that part.
double length_to(const Curve& curve, double t) {
    return length(curve, Interval{curve.domain().lo, t}, relative(1e-15)).value;
}

Curve wavy() {
    return hermite(Points({0, 0, 1, 2, 3, 1, 4, 4}, 2), Points({1, 0, 1, 1, 1, -1, 2, 2}, 2));
}

TEST(ArcLengthMap, PlacesHardCubicsToTwelveDigitsOfTheirLength) {
    SKIP_UNLESS_SHARED("reference/sampling/robustness_cases.json");
    const auto cases = shared_json("reference/sampling/robustness_cases.json");
    for (const auto& [name, hard] : cases.items()) {
        std::vector<double> control;
        for (const auto& point : hard["bezier"]) {
            for (const auto& x : point) control.push_back(std::stod(x.get<std::string>()));
        }
        const double exact = std::stod(hard["length"].get<std::string>());
        const Curve curve = bezier(control);
        const ArcLengthMap map(curve);
        EXPECT_NEAR(map.length(), exact, 1e-14 * exact) << name;
        for (const auto& [fraction, t] : hard["t_at_fraction"].items()) {
            const double s = std::stod(fraction) * exact;
            EXPECT_NEAR(map.s_of(std::stod(t.get<std::string>())), s, 1e-12 * exact) << name;
            EXPECT_NEAR(length_to(curve, map.t_of(s)), s, 1e-12 * exact) << name << fraction;
        }
        for (int i = 0; i <= 200; ++i) {
            const double s = map.length() * i / 201;
            EXPECT_NEAR(length_to(curve, map.t_of(s)), s, 1e-12 * exact) << name << i;
        }
    }
}

TEST(ArcLengthMap, IsTheParameterItselfOnLinesAndCircles) {
    const ArcLengthMap line(polyline(Points({0, 0, 3, 4, 3, 16}, 2)));
    EXPECT_NEAR(line.length(), 17, 1e-14);
    EXPECT_NEAR(line.t_of(2.5), 0.5, 1e-15);
    EXPECT_NEAR(line.t_of(11), 1.5, 1e-15);
    EXPECT_NEAR(line.s_of(1.25), 8, 1e-14);
    const ArcLengthMap circle(ellipse(25, 25));
    for (int i = 0; i <= 50; ++i) EXPECT_NEAR(circle.t_of(25 * 0.125 * i), 0.125 * i, 1e-12);
    const ArcLengthMap space(helix(3, 4));
    EXPECT_NEAR(space.length(), 5, 1e-13);
    EXPECT_NEAR(space.t_of(1.7), 0.34, 1e-12);
}

TEST(ArcLengthMap, MeetsBothEndsExactly) {
    const Curve curve = wavy();
    const ArcLengthMap map(curve);
    EXPECT_EQ(map.t_of(0.0), 0);
    EXPECT_EQ(map.t_of(map.length()), 3);
    EXPECT_EQ(map.s_of(0), 0);
    EXPECT_EQ(map.s_of(3), map.length());
}

TEST(ArcLengthMap, PassesPiecesThatStandStill) {
    const ArcLengthMap map(polyline(Points({0, 0, 1, 0, 1, 0, 2, 0}, 2)));
    EXPECT_EQ(map.length(), 2);
    EXPECT_NEAR(map.t_of(0.5), 0.5, 1e-15);
    EXPECT_NEAR(map.t_of(1.5), 2.5, 1e-15);
    EXPECT_EQ(map.s_of(1.5), 1);
    const ArcLengthMap rests(polyline(Points({0, 0, 0, 0, 1, 0, 1, 0}, 2)));
    EXPECT_EQ(rests.t_of(0.0), 0);
    EXPECT_EQ(rests.t_of(1.0), 3);
}

TEST(ArcLengthMap, MeetsTheJointsOfACurveWhicheverIsAskedFirst) {
    const Curve curve = wavy();
    for (const double first : {0.5, 1.5, 2.5}) {
        const ArcLengthMap map(curve);
        map.s_of(first);
        for (int i = 0; i <= 3; ++i) EXPECT_NEAR(map.t_of(map.s_of(i)), i, 1e-14);
        EXPECT_EQ(map.s_of(1.25), ArcLengthMap(curve).s_of(1.25));
    }
}

TEST(ArcLengthMap, TellsWhereItsCellsMeet) {
    const ArcLengthMap map(wavy());
    const std::span<const double> joints = map.joints();
    EXPECT_EQ(joints.front(), 0);
    EXPECT_EQ(joints.back(), 3);
    EXPECT_TRUE(std::is_sorted(joints.begin(), joints.end()));
    for (const double t : {1.0, 2.0}) {
        EXPECT_TRUE(std::binary_search(joints.begin(), joints.end(), t)) << t;
    }
}

TEST(ArcLengthMap, FollowsPiecesThatAreNothingBesideTheOthers) {
    // 1e-60 of the length: its inverse is taken to be even.
    const Curve curve = polyline(Points({0, 0, 1, 0, 1, 1e-60, 2, 1e-60}, 2));
    const ArcLengthMap map(curve);
    EXPECT_EQ(map.length(), 2);
    EXPECT_NEAR(map.t_of(0.25), 0.25, 1e-15);
    EXPECT_NEAR(map.t_of(1.25), 2.25, 1e-15);
    EXPECT_EQ(map.s_of(1.5), 1);
}

TEST(ArcLengthMap, AnswersManyAtOnceWithTheSameBits) {
    const Curve curve = wavy();
    const ArcLengthMap map(curve);
    std::vector<double> s, t(1001);
    for (int i = 0; i <= 1000; ++i) s.push_back(map.length() * (i % 7 == 0 ? 1000 - i : i) / 1000);
    map.t_of(s, t);
    for (std::size_t i = 0; i < s.size(); ++i) EXPECT_EQ(t[i], map.t_of(s[i])) << i;
}

}  // namespace arc_length_map_test
}  // namespace batten
