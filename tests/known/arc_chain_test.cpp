#include "batten/shape/arc_chain.hpp"

#include <cmath>
#include <numbers>

#include "batten/shape/curve.hpp"
#include "shared.hpp"

namespace batten {
namespace arc_chain_test {

constexpr double pi = std::numbers::pi;

TEST(Arc, OfBulgeOneIsHalfACircle) {
    const Arc arc{{1, 0}, {-1, 0}, 1};
    EXPECT_DOUBLE_EQ(arc.sweep(), pi);
    EXPECT_DOUBLE_EQ(arc.length(), pi);
    EXPECT_DOUBLE_EQ(*arc.radius(), 1);
    EXPECT_NEAR((*arc.center())[0], 0, 1e-16);
    EXPECT_NEAR((*arc.center())[1], 0, 1e-16);
    EXPECT_NEAR(arc.start_tangent()[1], 1, 1e-16);
    EXPECT_NEAR(arc.end_tangent()[1], -1, 1e-16);
}

TEST(Arc, KnowsItsGeometryForEverySweep) {
    for (int degrees = -350; degrees <= 350; degrees += 10) {
        const double sweep = degrees * pi / 180, radius = 2.5;
        const double sign = sweep < 0 ? -1 : 1;
        // Round (3, 4), from the angle 0.3 on.
        const auto at = [&](double angle) {
            return std::array{3 + radius * std::cos(angle), 4 + radius * std::sin(angle)};
        };
        const Arc arc{at(0.3), at(0.3 + sweep), std::tan(sweep / 4)};
        EXPECT_NEAR(arc.sweep(), sweep, 1e-14);
        if (degrees == 0) continue;
        EXPECT_NEAR(*arc.radius(), radius, 1e-13);
        EXPECT_NEAR((*arc.center())[0], 3, 1e-13);
        EXPECT_NEAR((*arc.center())[1], 4, 1e-13);
        EXPECT_NEAR(arc.curvature(), sign / radius, 1e-13);
        EXPECT_NEAR(arc.length(), radius * std::fabs(sweep), 1e-12);
        EXPECT_NEAR(arc.start_tangent()[0], -sign * std::sin(0.3), 1e-13);
        EXPECT_NEAR(arc.end_tangent()[1], sign * std::cos(0.3 + sweep), 1e-13);
    }
}

TEST(Arc, OfNoBulgeIsALine) {
    const Arc line{{1, 2}, {4, 6}, 0};
    EXPECT_TRUE(line.is_line());
    EXPECT_EQ(line.length(), 5);
    EXPECT_EQ(line.curvature(), 0);
    EXPECT_FALSE(line.radius());
    EXPECT_FALSE(line.center());
    EXPECT_DOUBLE_EQ(line.start_tangent()[0], 0.6);
    EXPECT_DOUBLE_EQ(line.end_tangent()[1], 0.8);
}

TEST(ArcChainCurve, RunsThroughItsArcsByArcLength) {
    const ArcChain chain(Points({0, 0, 2, 0, 2, 2, 0, 2}, 2), {0, 1, 0});
    const Curve curve(chain);
    EXPECT_EQ(curve.pieces(), 3u);
    EXPECT_FALSE(curve.degree());
    EXPECT_DOUBLE_EQ(curve.domain().hi, 4 + pi);
    const Jet jet = curve.jet(2 + pi / 2, 3);
    const std::vector<double> expected{3, 1, 0, 1, -1, 0, 0, -1};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(jet.values()[i], expected[i], 1e-15);
    EXPECT_EQ(Curve(ArcChain(Points({0, 0, 1, 0, 1, 1}, 2), {0, 0})).degree(), 1);
}

TEST(ArcChainCurve, OfNearlyStraightArcsLosesNoDigits) {
    for (const double bulge : {1e-3, 1e-6, 1e-9, 1e-12, 1e-300}) {
        const ArcChain chain(Points({0, 0, 2, 0}, 2), {bulge});
        const double middle = chain.breaks()[1] / 2;
        const std::vector<double> p = Curve(chain)(middle);
        EXPECT_NEAR(p[0], 1, 1e-15);
        EXPECT_NEAR(p[1], -bulge, 1e-15 * bulge);  // the sagitta: chord x bulge / 2
        EXPECT_NEAR(chain.arc(0).curvature(), 2 * bulge / (1 + bulge * bulge), 1e-15 * bulge);
    }
}

}  // namespace arc_chain_test
}  // namespace batten
