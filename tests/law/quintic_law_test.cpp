#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "batten/make/convert.hpp"
#include "batten/make/interpolate.hpp"
#include "batten/measure/continuity.hpp"

namespace batten {
namespace quintic_law_test {

Points ring(std::size_t n) {
    Points points(0, 2);
    for (std::size_t i = 0; i < n; ++i) {
        const double t = 2 * 3.14159265358979 * double(i) / double(n);
        points.push_back(std::vector{(2 + std::cos(3 * t)) * std::cos(t), std::sin(t)});
    }
    return points;
}

double gap(const Curve& a, const Curve& b) {
    double most = 0;
    const Interval domain = a.domain();
    for (int i = 0; i <= 500; ++i) {
        const double t = domain.lo + domain.length() * i / 500;
        for (std::size_t k = 0; k < 2; ++k) most = std::fmax(most, std::fabs(a(t)[k] - b(t)[k]));
    }
    return most;
}

/// Closed and open, smooth and with corners: cubics are quintics.
TEST(Quintics, OfCubicsAreThoseCubics) {
    for (const bool closed : {false, true}) {
        for (const std::vector<int>& corners : {std::vector<int>{}, std::vector<int>{4, 7}}) {
            InterpolateOptions options;
            options.closed = closed;
            options.corner = corners;
            const Curve curve = interpolate(ring(12), options).curve;
            const BSplineCurve quintic = to_quintic(curve, 1e-9);
            EXPECT_EQ(quintic.is_closed(), closed);
            EXPECT_EQ(Curve(quintic).pieces(), curve.pieces());
            EXPECT_LT(gap(curve, quintic), 1e-13);
        }
    }
}

TEST(Quintics, KeepOneClosedPiece) {
    const CallableCurve circle{
        [](double t, int order, std::span<double> out) {
            for (int k = 0; k <= order; ++k) {
                out[std::size_t(2 * k)] = std::cos(t + k * 1.5707963267948966);
                out[std::size_t(2 * k + 1)] = std::sin(t + k * 1.5707963267948966);
            }
        },
        2, {0, 6.283185307179586}, true};
    const BSplineCurve quintic = to_quintic(Curve(circle), 1e-8);
    EXPECT_LT(gap(Curve(circle), quintic), 1e-8);
    EXPECT_TRUE(quintic.is_closed());
    for (const Joint& joint : continuity(Curve(quintic))) {
        EXPECT_EQ(joint.continuity, Continuity::C2);
    }
}

}  // namespace quintic_law_test
}  // namespace batten
