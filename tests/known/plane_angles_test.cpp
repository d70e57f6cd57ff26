#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "num/plane_angles.hpp"
#include "random.hpp"

namespace batten {
namespace plane_angles_test {

using batten::testing::Random;
using patches::Level;
using std::numbers::pi;

struct Vectors {
    std::vector<double> x, y;
};

/// Of all lengths and directions, some a hair's breadth from an axis or a diagonal.
Vectors vectors(std::size_t count) {
    Random random(3);
    Vectors v{std::vector<double>(count), std::vector<double>(count)};
    for (std::size_t i = 0; i < count; ++i) {
        const double scale = std::exp(random.within(-200, 200));
        const double off = random.within(-1, 1) * std::exp(random.within(-40, 0));
        const double angle = i % 2 == 0 ? random.within(-pi, pi) : std::round(off * 99) * pi / 4 + off;
        v.x[i] = scale * std::cos(angle);
        v.y[i] = scale * std::sin(angle);
    }
    return v;
}

std::vector<double> angles_at(Level level, const Vectors& v) {
    std::vector<double> angles(v.x.size());
    num::fill_angles_at(level, v.x, v.y, angles);
    return angles;
}

TEST(AnglesOfVectors, AreThoseOfTheLibraryToThreeUlps) {
    const Vectors v = vectors(20'000);
    const std::vector<double> angles = angles_at(Level::plain, v);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double exact = std::atan2(v.y[i], v.x[i]);
        const double ulp = std::ldexp(1.0, std::ilogb(exact) - 52);
        EXPECT_NEAR(angles[i], exact, 3.5 * ulp) << v.x[i] << ' ' << v.y[i];
    }
}

TEST(AnglesOfVectors, AreExactOnTheAxes) {
    const Vectors v{{1, 2, 0, -0.0, 0, -1, -3, 1}, {0, -0.0, 1, 1, -2, 0, -0.0, 1}};
    EXPECT_EQ(angles_at(Level::plain, v),
              (std::vector<double>{0, 0, pi / 2, pi / 2, -pi / 2, pi, pi, pi / 4}));
}

TEST(DirectionsOfAngles, AreThoseOfTheLibrary) {
    Random random(4);
    std::vector<double> angles(20'000), cosines(20'000), sines(20'000), opposite(20'000);
    for (double& a : angles) a = random.within(-4, 4);
    angles[0] = 0;
    num::fill_directions(angles, cosines, sines);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        EXPECT_NEAR(cosines[i], std::cos(angles[i]), 3e-16) << angles[i];
        EXPECT_NEAR(sines[i], std::sin(angles[i]), 3e-16) << angles[i];
        opposite[i] = -angles[i];
    }
    EXPECT_EQ(cosines[0], 1);
    EXPECT_EQ(sines[0], 0);
    std::vector<double> same(20'000), negative(20'000);
    num::fill_directions(opposite, same, negative);
    EXPECT_EQ(same, cosines);
    for (double& s : negative) s = -s;
    EXPECT_EQ(negative, sines);
}

TEST(EveryLevel, GivesTheSameAnglesAndDirectionsBitForBit) {
    const Vectors v = vectors(5'001);
    const std::vector<double> angles = angles_at(Level::plain, v);
    std::vector<double> cosines(angles.size()), sines(angles.size());
    num::fill_directions_at(Level::plain, angles, cosines, sines);
    for (const Level level : {Level::avx2, Level::avx512}) {
        if (!patches::is_offered(level)) continue;
        EXPECT_EQ(angles_at(level, v), angles);
        std::vector<double> x(angles.size()), y(angles.size());
        num::fill_directions_at(level, angles, x, y);
        EXPECT_EQ(x, cosines);
        EXPECT_EQ(y, sines);
    }
}

}  // namespace plane_angles_test
}  // namespace batten
