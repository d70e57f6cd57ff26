#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "batten/base/progress.hpp"
#include "batten/make/interpolate.hpp"

namespace batten {
namespace {

Points wave(int n) {
    Points points(2);
    for (int i = 0; i < n; ++i) points.push_back(std::vector<double>{1.0 * i, std::sin(0.7 * i)});
    return points;
}

std::vector<double> shares_of(Method method) {
    std::vector<double> shares;
    InterpolateOptions options;
    options.method = method;
    options.exact = true;
    options.progress = Progress([&](double share) {
        shares.push_back(share);
        return true;
    });
    interpolate(wave(12), options);
    return shares;
}

TEST(Progress, OfAPseudoSplineGrowsFromNearNothingToAll) {
    for (const Method method : {Method::pseudo_spline, Method::pseudo_spline_global}) {
        const std::vector<double> shares = shares_of(method);
        ASSERT_GE(shares.size(), 12U);
        EXPECT_LT(shares.front(), 0.1);
        EXPECT_EQ(shares.back(), 1);
        for (std::size_t i = 1; i < shares.size(); ++i) EXPECT_GE(shares[i], shares[i - 1]);
    }
}

TEST(Progress, StopsTheWorkAsSoonAsItIsAskedTo) {
    int calls = 0;
    InterpolateOptions options;
    options.progress = Progress([&](double share) {
        ++calls;
        return share < 0.3;
    });
    EXPECT_THROW(interpolate(wave(40), options), Cancelled);
    EXPECT_LT(calls, 20);
}

// Told span by span, it can stop the work within microseconds, however many spans there are.
TEST(Progress, OfTheGlobalSplineIsToldSpanBySpanOfEveryStep) {
    const std::size_t n = 40;
    InterpolateOptions options;
    options.method = Method::pseudo_spline_global;
    std::size_t calls = 0;
    options.progress = Progress([&](double) { return ++calls > 0; });
    interpolate(wave(n), options);
    EXPECT_GT(calls, 8 * n);
    for (const std::size_t last : {calls / 10, calls / 3, calls / 2, calls - 3}) {
        std::size_t told = 0;
        options.progress = Progress([&](double) { return ++told < last; });
        EXPECT_THROW(interpolate(wave(n), options), Cancelled);
        EXPECT_EQ(told, last);
    }
}

TEST(Progress, ChangesNoResult) {
    InterpolateOptions watched;
    watched.progress = Progress([](double) { return true; });
    const Interpolation a = interpolate(wave(9), {}), b = interpolate(wave(9), watched);
    EXPECT_EQ(a.report.length, b.report.length);
    EXPECT_EQ(*a.report.tangent_angles, *b.report.tangent_angles);
}

TEST(Progress, OfAStageIsItsShareOfTheWhole) {
    double last = -1;
    const Progress whole([&](double share) {
        last = share;
        return true;
    });
    whole.stage(0.5, 1).stage(0, 0.5).at(1, 2);
    EXPECT_EQ(last, 0.625);
    whole.stage(0.5, 1).at(0, 0);
    EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace batten
