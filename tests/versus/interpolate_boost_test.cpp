#include <gtest/gtest.h>
#include <math.h>  // Boost 1.74 asks for ::isnan

#include <boost/math/interpolators/makima.hpp>
#include <boost/math/interpolators/pchip.hpp>
#include <vector>

#include "batten/make/interpolate.hpp"
#include "random.hpp"

namespace batten {
namespace interpolate_boost_test {

/// x rising, y between -2 and 2, some of them equal.
Points data(testing::Random& random, std::size_t count) {
    Points points(count, 2);
    double x = random.within(-5, 5);
    for (std::size_t i = 0; i < count; ++i) {
        points(i, 0) = x += random.within(0.1, 2);
        points(i, 1) = random.whole(0, 2) == 0 ? random.whole(-2, 2) : random.within(-2, 2);
    }
    return points;
}

std::vector<double> column(const Points& points, int k) {
    std::vector<double> values;
    for (std::size_t i = 0; i < points.size(); ++i) values.push_back(points(i, k));
    return values;
}

template <class MakePeer>
void compare(Method method, MakePeer&& make_peer) {
    testing::Random random(21);
    for (int trial = 0; trial < 60; ++trial) {
        const Points points = data(random, static_cast<std::size_t>(random.whole(4, 12)));
        InterpolateOptions options;
        options.method = method;
        const Curve curve = curve_through(points, options);
        const auto peer = make_peer(points, curve);
        for (int i = 0; i < 40; ++i) {
            const double x = random.within(curve.domain().lo, curve.domain().hi);
            const Jet jet = curve.jet(x, 1);
            ASSERT_NEAR(jet[0][0], x, 4e-15);
            ASSERT_NEAR(jet[0][1], peer(x), 1e-14);
            ASSERT_NEAR(jet[1][1], peer.prime(x), 4e-13);
        }
    }
}

TEST(Interpolate, AgreesWithBoostOnMakima) {
    compare(Method::makima, [](const Points& points, const Curve&) {
        return boost::math::interpolators::makima(column(points, 0), column(points, 1));
    });
}

TEST(Interpolate, AgreesWithBoostOnPchipBetweenTheSameEndSlopes) {
    compare(Method::pchip, [](const Points& points, const Curve& curve) {
        return boost::math::interpolators::pchip(column(points, 0), column(points, 1),
                                                 curve.jet(curve.domain().lo, 1)[1][1],
                                                 curve.jet(curve.domain().hi, 1)[1][1]);
    });
}

}  // namespace interpolate_boost_test
}  // namespace batten
