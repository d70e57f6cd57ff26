#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "batten/measure/deviation.hpp"
#include "batten/measure/length.hpp"
#include "curves.hpp"
#include "random.hpp"

namespace batten {
namespace measure_length_sweep_test {

using namespace batten::testing;

/// The length in extended precision, by somebody else's code.
double slow_length(const Curve& curve) {
    long double sum = 0;
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const Interval piece = curve.piece(i);
        const auto speed = [&](long double t) {
            long double square = 0;
            const Jet jet = curve.jet_on(i, static_cast<double>(t), 1);
            for (const double x : jet[1]) square += static_cast<long double>(x) * x;
            return std::sqrt(square);
        };
        sum += boost::math::quadrature::gauss_kronrod<long double, 31>::integrate(
            speed, static_cast<long double>(piece.lo), static_cast<long double>(piece.hi), 12,
            1e-15L);
    }
    return static_cast<double>(sum);
}

std::vector<Curve> random_curves() {
    Random random(7);
    std::vector<Curve> curves;
    for (int i = 0; i < 40; ++i) {
        std::vector<double> control(i % 2 == 0 ? 8 : 12);
        for (double& x : control) x = random.within(0, 1);
        curves.push_back(bezier(control, i % 2 == 0 ? 2 : 3));
    }
    for (int i = 0; i < 5; ++i) {
        const auto wave = [&] {
            return Wave{random.within(0.1, 1), static_cast<double>(random.whole(1, 4)),
                        random.within(0, 6)};
        };
        curves.push_back(waves({{wave(), wave()}, {wave(), wave()}}, {0, 2, 6.28}, false));
    }
    return curves;
}

TEST(ArcLength, IsAsExactAsAskedAndKnowsItsError) {
    for (const Curve& curve : random_curves()) {
        const double exact = slow_length(curve);
        for (int digits = 1; digits <= 12; ++digits) {
            const double asked = std::pow(10.0, -digits);
            const Measured measured = length(curve, absolute(asked));
            const double error = std::fabs(measured.value - exact);
            EXPECT_LE(error, asked);
            EXPECT_LE(error, measured.error + 1e-15 * exact) << "the truth is known to 1e-15";
            EXPECT_LE(measured.error, asked + 0x1p-46 * exact);
        }
    }
}

TEST(ArcLength, ToleranceMeansTheWholeCurveHoweverManyPieces) {
    Random random(11);
    const Points points = random.points(60, 2), slopes = random.points(60, 2);
    const Curve curve = hermite(points, slopes);
    const double exact = slow_length(curve);
    for (int digits = 1; digits <= 12; ++digits) {
        const double asked = std::pow(10.0, -digits);
        EXPECT_NEAR(length(curve, absolute(asked)).value, exact, asked + 1e-15 * exact);
    }
}

TEST(HausdorffDistance, IsAsExactAsAskedAndKnowsItsError) {
    Random random(5);
    for (int i = 0; i < 10; ++i) {
        const Points a = random.points(5, 2), b = random.points(5, 2);
        const Points slopes = random.points(5, 2);
        const Curve first = hermite(a, slopes), second = hermite(b, slopes);
        const double exact = hausdorff(first, second, absolute(1e-10)).value;
        for (int digits = 1; digits <= 8; ++digits) {
            const double asked = std::pow(10.0, -digits);
            const Measured measured = hausdorff(first, second, absolute(asked));
            EXPECT_LE(std::fabs(measured.value - exact), asked + 1e-10);
            EXPECT_LE(std::fabs(measured.value - exact), measured.error + 1e-10);
            EXPECT_LE(measured.error, asked + 1e-13);
        }
    }
}

}  // namespace measure_length_sweep_test
}  // namespace batten
