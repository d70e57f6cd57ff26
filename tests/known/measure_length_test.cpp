#include <gtest/gtest.h>

#include <cmath>

#include "batten/measure/centroid.hpp"
#include "batten/measure/length.hpp"
#include "batten/shape/bspline.hpp"
#include "curves.hpp"
#include "shared_json.hpp"

namespace batten {
namespace measure_length_test {

using namespace batten::testing;

/// The hard cubics: control points and their length to 20 digits.
struct HardCase {
    const char* name;
    std::vector<double> control;
    double length;
};

const std::vector<HardCase> hard_cases{
    {"cusp", {0, 0, 1, 1, 0, 1, 1, 0}, 1.8284271247461900976},
    {"near_cusp", {0, 0, 1, 1, 0.001, 1, 1, 0}, 1.8282993367024019035},
    {"loop", {0, 0, 2, 1, -1, 1, 1, 0}, 2.5362426519045331658},
    {"straight_backtrack", {0, 0, 3, 0, -2, 0, 1, 0}, 3},
    {"straight_nonuniform", {0, 0, 0, 0, 3, 0, 3, 0}, 3},
    {"quarter_arc",
     {1, 0, 1, 0.5522847498307936, 0.5522847498307936, 1, 0, 1},
     1.5710166980738557388},
    {"high_aspect", {0, 0, 1000, 1, -1000, 1, 1, 0}, 1154.743482125067446},
    {"tiny_start_speed", {0, 0, 1e-9, 0, 1, 1, 2, 0}, 2.2434874177359695178}};

TEST(ArcLength, OfHardCubicsIsRightTo14Digits) {
    for (const HardCase& hard : hard_cases) {
        const Measured measured = length(bezier(hard.control));
        EXPECT_NEAR(measured.value, hard.length, 1e-14 * hard.length) << hard.name;
        EXPECT_LE(std::fabs(measured.value - hard.length), measured.error) << hard.name;
    }
}

TEST(ArcLength, OfHardCubicsIsRightTo14DigitsInEveryDirection) {
    for (const HardCase& hard : hard_cases) {
        for (int i = 1; i < 12; ++i) {
            const Curve turned = mapped(bezier(hard.control), rotation(0.55 * i));
            // Turning rounds the control points by an ulp of the largest, 1000 for a length of 1155.
            EXPECT_NEAR(length(turned).value, hard.length, 1e-14 * hard.length) << hard.name << i;
        }
    }
}

TEST(ArcLength, OfHardCubicsStandingInSpaceIsRightTo14Digits) {
    for (const HardCase& hard : hard_cases) {
        std::vector<double> control;
        for (std::size_t i = 0; i < 4; ++i) {
            control.push_back(hard.control[2 * i]);
            control.push_back(0.6 * hard.control[2 * i + 1]);
            control.push_back(0.8 * hard.control[2 * i + 1]);
        }
        EXPECT_NEAR(length(bezier(control, 3)).value, hard.length, 1e-14 * hard.length)
            << hard.name;
    }
}

TEST(ArcLength, EqualsTheReferenceFile) {
    SKIP_UNLESS_SHARED("reference/sampling/robustness_cases.json");
    const auto cases = shared_json("reference/sampling/robustness_cases.json");
    for (const auto& [name, hard] : cases.items()) {
        std::vector<double> control;
        for (const auto& point : hard["bezier"]) {
            for (const auto& x : point) control.push_back(std::stod(x.get<std::string>()));
        }
        const double exact = std::stod(hard["length"].get<std::string>());
        EXPECT_NEAR(length(bezier(control)).value, exact, 1e-14 * exact) << name;
        for (const auto& [fraction, t] : hard["t_at_fraction"].items()) {
            const double part = length(bezier(control), Interval{0, std::stod(t.get<std::string>())}).value;
            EXPECT_NEAR(part, std::stod(fraction) * exact, 1e-12 * exact) << name << fraction;
        }
    }
}

TEST(ArcLength, OfStraightLinesIsTheirDistance) {
    EXPECT_EQ(length(polyline(Points({0, 0, 3, 4}, 2))).value, 5);
    EXPECT_EQ(length(polyline(Points({1, 1, 1, 4, 4, 5, 3, 6}, 4))).value,
              std::sqrt(9.0 + 16 + 4 + 4));
    EXPECT_EQ(length(polyline(Points({0, 0, 1, 0, 0, 0}, 2))).value, 2) << "there and back";
}

TEST(ArcLength, OfAParabolaIsItsClosedForm) {
    const double exact = std::sqrt(5.0) / 2 + std::asinh(2.0) / 4;
    EXPECT_NEAR(length(bezier({0, 0, 1.0 / 3, 0, 2.0 / 3, 1.0 / 3, 1, 1})).value, exact, 3e-16);
}

TEST(ArcLength, OfASpaceCubic) {
    const Curve curve = bezier({0, 0, 0, 1, 2, 0, 0, 1, 3, 2, 0, 1}, 3);
    EXPECT_NEAR(length(curve).value, 4.2829149289571385773, 2e-15);
}

TEST(ArcLength, OfCirclesEllipsesAndHelicesGivenAsFunctions) {
    const double pi = std::numbers::pi;
    const std::vector<std::pair<Curve, double>> cases{
        {ellipse(1, 1), 2 * pi},
        {ellipse(1e-3, 1e-3), 2e-3 * pi},
        {ellipse(2, 1), 9.6884482205476761984},
        {helix(3, 4), 5}};
    for (const auto& [curve, exact] : cases) {
        const Measured measured = length(curve);
        EXPECT_NEAR(measured.value, exact, 2e-14 * exact);
        EXPECT_LE(std::fabs(measured.value - exact), measured.error);
    }
}

TEST(ArcLength, OfACycloidWithItsCuspIsEightRadii) {
    // x = t - sin t, y = 1 - cos t: at rest at 0 and 2 pi, so the third curve has a cusp inside.
    const double turn = 2 * std::numbers::pi;
    const auto cycloid = [](std::vector<double> breaks) {
        return CallableCurve{[](double t, int order, std::span<double> out) {
                                 const Wave x{-1, 1, -quarter}, y{-1, 1, 0};
                                 for (int k = 0; k <= order; ++k) {
                                     out[2 * k] = x.derivative(t, k) +
                                                  (k == 0 ? t : k == 1 ? 1 : 0);
                                     out[2 * k + 1] = y.derivative(t, k) + (k == 0 ? 1 : 0);
                                 }
                             },
                             2, std::move(breaks), false};
    };
    EXPECT_NEAR(length(cycloid({0, turn})).value, 8, 1e-13);
    EXPECT_NEAR(length(cycloid({0, turn, 2 * turn})).value, 16, 2e-13);
    EXPECT_NEAR(length(cycloid({1, 1 + turn})).value, 8, 1e-13);
}

TEST(ArcLength, OfAPointIsZero) {
    EXPECT_EQ(length(bezier({2, 3, 2, 3, 2, 3, 2, 3})).value, 0);
    EXPECT_EQ(length(ellipse(1, 1), Interval{1, 1}).value, 0);
}

TEST(ArcLength, FarFromTheOriginIsAsGoodAsTheCoordinates) {
    const Curve near = bezier({0, 0, 1, 2, 3, 3, 4, 0});
    const Curve far = bezier({1e6, 1e6, 1e6 + 1, 1e6 + 2, 1e6 + 3, 1e6 + 3, 1e6 + 4, 1e6});
    EXPECT_NEAR(length(far).value, length(near).value, 4 * 1.2e-10);
}

TEST(Centroid, OfKnownCurves) {
    const std::vector<double> straight = centroid(polyline(Points({0, 0, 2, 4}, 2)));
    EXPECT_NEAR(straight[0], 1, 1e-15);
    EXPECT_NEAR(straight[1], 2, 1e-15);
    const Curve half = waves({{{1, 1, 0}}, {{1, 1, -quarter}}}, {0, std::numbers::pi}, false);
    EXPECT_NEAR(centroid(half)[0], 0, 1e-14);
    EXPECT_NEAR(centroid(half)[1], 2 / std::numbers::pi, 1e-14);
    const std::vector<double> space = centroid(bezier({0, 0, 0, 1, 2, 0, 0, 1, 3, 2, 0, 1}, 3));
    EXPECT_NEAR(space[0], 0.822184118446871541, 1e-14);
    EXPECT_NEAR(space[1], 0.6442041061277627, 1e-14);
    EXPECT_NEAR(space[2], 0.954557475894557601, 1e-14);
    EXPECT_EQ(centroid(bezier({2, 3, 2, 3, 2, 3, 2, 3})), (std::vector<double>{2, 3}));
}

}  // namespace measure_length_test
}  // namespace batten
