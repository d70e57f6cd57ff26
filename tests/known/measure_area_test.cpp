#include <gtest/gtest.h>

#include <cmath>

#include "batten/measure/area.hpp"
#include "curves.hpp"

namespace batten {
namespace measure_area_test {

using namespace batten::testing;
constexpr double pi = std::numbers::pi;

TEST(Area, OfPolygonsIsExact) {
    EXPECT_EQ(area(polyline(Points({0, 0, 3, 0, 3, 2, 0, 2, 0, 0}, 2), true)).value, 6);
    EXPECT_EQ(area(polyline(Points({0, 0, 0, 2, 3, 2, 3, 0, 0, 0}, 2), true)).value, -6);
    EXPECT_EQ(area(polyline(Points({0, 0, 3, 0, 3, 2}, 2))).value, 3) << "closed by its chord";
}

TEST(Area, OfAParabolaAndItsChordIsOneSixth) {
    const Measured measured = area(bezier({0, 0, 1.0 / 3, 0, 2.0 / 3, 1.0 / 3, 1, 1}));
    EXPECT_NEAR(measured.value, 1.0 / 6, 1e-16);
}

TEST(Area, OfEllipsesGivenAsFunctions) {
    for (const auto& [a, b] : {std::pair{1.0, 1.0}, {2.0, 1.0}, {1.0, 1e-3}, {1e4, 3e4}}) {
        const Measured measured = area(ellipse(a, b));
        EXPECT_NEAR(measured.value, pi * a * b, 1e-14 * std::fmax(a, b) * std::fmax(a, b) * pi);
        EXPECT_LE(std::fabs(measured.value - pi * a * b), measured.error);
    }
}

TEST(Area, DoesNotLoseDigitsFarFromTheOrigin) {
    const Curve far = mapped(bezier({0, 0, 1, 0, 1, 1, 0, 1}), {1, 0, 0, 1, 0x1p30, -0x1p30});
    const double exact = area(bezier({0, 0, 1, 0, 1, 1, 0, 1})).value;
    // The coordinates are rounded to 2^-23.
    EXPECT_NEAR(area(far).value, exact, 0x1p-21);
}

TEST(AreaByWinding, OfASimpleCurveIsAllOnOneSide) {
    const auto left = areas_by_winding(ellipse(2, 1));
    ASSERT_TRUE(left);
    EXPECT_EQ(left->positive, area(ellipse(2, 1)).value);
    EXPECT_EQ(left->negative, 0);
    const auto right = areas_by_winding(mapped(ellipse(2, 1), {1, 0, 0, -1, 0, 0}));
    EXPECT_EQ(right->positive, 0);
    EXPECT_NEAR(right->negative, 2 * pi, 1e-13);
}

TEST(AreaByWinding, OfAFigureEightIsHalfAndHalf) {
    // x = cos t, y = sin 2 t / 2, turned a little; each lobe has the area 2/3.
    const Curve eight = waves({{{1, 1, 0.3}}, {{0.5, 2, 0.6 - quarter}}}, {0, 2 * pi});
    for (const double angle : {0.0, 0.7, 1.5707963267948966, 2.9}) {
        const auto parts = areas_by_winding(mapped(eight, rotation(angle)));
        ASSERT_TRUE(parts);
        EXPECT_NEAR(parts->positive, 2.0 / 3, 1e-13) << angle;
        EXPECT_NEAR(parts->negative, 2.0 / 3, 1e-13) << angle;
    }
}

TEST(AreaByWinding, CountsTwiceWhatIsWoundAroundTwice) {
    // The limacon r = 1 + 2 cos t: its inner loop of area pi - 3 sqrt(3) / 2 has winding number 2.
    const Curve limacon = waves({{{1, 1, 0}, {1, 2, 0}, {1, 0, 0}},
                                 {{1, 1, -quarter}, {1, 2, -quarter}}},
                                {0, 2 * pi});
    const auto parts = areas_by_winding(limacon);
    ASSERT_TRUE(parts);
    EXPECT_NEAR(parts->positive, 3 * pi, 1e-12);
    EXPECT_EQ(parts->negative, 0);
    const Curve twice = waves({{{1, 1, 0}}, {{1, 1, -quarter}}}, {0, 4 * pi});
    EXPECT_NEAR(areas_by_winding(twice)->positive, 2 * pi, 1e-12);
}

TEST(AreaByWinding, OfAPentagramCountsItsCoreTwice) {
    Points star(2);
    for (int i = 0; i <= 5; ++i) {
        const double angle = (2 * i % 5) * 2 * pi / 5;
        star.push_back(std::vector<double>{std::cos(angle), std::sin(angle)});
    }
    const auto parts = areas_by_winding(polyline(star, true));
    ASSERT_TRUE(parts);
    // The signed area 5/2 sin(4 pi / 5) counts the core twice and the tips once.
    EXPECT_NEAR(parts->positive, 2.5 * std::sin(4 * pi / 5), 1e-14);
    EXPECT_EQ(parts->negative, 0);
}

TEST(AreaByWinding, OfACubicLoopClosedByItsChord) {
    // Symmetric about x = 1/2 with as much area to the left as to the right.
    const Curve loop = bezier({0, 0, 2, 1, -1, 1, 1, 0});
    const auto parts = areas_by_winding(loop);
    ASSERT_TRUE(parts);
    EXPECT_NEAR(area(loop).value, 0, 1e-15);
    EXPECT_NEAR(parts->positive, parts->negative, 1e-14);
    // x = 6 t - 15 t^2 + 10 t^3 and y = 3 t - 3 t^2 meet where 10 t^2 - 10 t + 1 = 0.
    const double t = 0.5 - std::sqrt(0.15);
    const auto moment = [](double s) {  // int x y' dt
        return 9 * s * s - 27 * s * s * s + 30 * s * s * s * s - 12 * s * s * s * s * s;
    };
    EXPECT_NEAR(parts->positive, moment(1 - t) - moment(t), 1e-13);
}

TEST(AreaByWinding, OfALineThereAndBackIsNothing) {
    const auto parts = areas_by_winding(polyline(Points({0, 0, 2, 1, 0, 0}, 2), true));
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->positive, 0);
    EXPECT_EQ(parts->negative, 0);
}

TEST(AreaByWinding, OfAScribbleIsGivenUp) {
    Points scribble(2);
    for (int i = 0; i < 4000; ++i) {
        scribble.push_back(std::vector<double>{std::sin(1.7 * i), std::sin(2.3 * i)});
    }
    EXPECT_FALSE(areas_by_winding(polyline(scribble)));
}

}  // namespace measure_area_test
}  // namespace batten
