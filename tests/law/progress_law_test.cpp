#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "batten/api/operation.hpp"
#include "batten/base/progress.hpp"
#include "batten/make/fit.hpp"
#include "batten/make/fit_curve.hpp"
#include "batten/make/interpolate.hpp"

namespace batten {
namespace progress_law_test {

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

/// Fits a wave of 60 samples with the listener, in the ways that can take long.
template <class Listener>
void fit_in_every_way(Listener listener) {
    const Points points = wave(60);
    std::vector<double> x, y;
    for (std::size_t i = 0; i < points.size(); ++i) {
        x.push_back(points(i, 0));
        y.push_back(points(i, 1));
    }
    FitOptions options;
    options.sigma = 0.2;
    options.progress = Progress(listener);
    for (const KnotPlacement knots :
         {KnotPlacement::automatic, KnotPlacement::equal, KnotPlacement::free,
          KnotPlacement::pruned}) {
        options.knots = knots;
        fit({x, y, {}}, options);
    }
    options.knots = KnotPlacement::automatic;
    fit_curve(points, {}, options);
    options.tolerance = absolute(0.1);
    fit({x, y, {}}, options);
}

TEST(Progress, OfEveryFitGrowsToAll) {
    int fits = 0;
    double last = 0;
    fit_in_every_way([&](double share) {
        if (last == 1) last = 0;
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1);
        last = share;
        fits += share == 1;
        return true;
    });
    EXPECT_EQ(fits, 6);
}

TEST(Progress, StopsEveryFitAsSoonAsItIsAskedTo) {
    int calls = 0;
    EXPECT_THROW(fit_in_every_way([&](double) { return ++calls < 3; }), Cancelled);
    EXPECT_EQ(calls, 3);
    int fits = 0;
    for (int spared = 0; spared < 6; ++spared) {
        int done = 0;
        EXPECT_THROW(fit_in_every_way([&](double share) {
                         if (done == spared) return false;
                         done += share == 1;
                         return true;
                     }),
                     Cancelled);
        fits += done == spared;
    }
    EXPECT_EQ(fits, 6);
}

TEST(Progress, ReachesAFitThroughTheTableOfOperations) {
    const Input input{"wave", PointsInput{parse_table({"w.csv", "0,0\n1,1\n2,0\n3,1\n4,0\n"}), {}}};
    const Progress refusing([](double) { return false; });
    EXPECT_THROW(find_operation("fit")->run({&input, 1}, {}, refusing), Cancelled);
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

}  // namespace progress_law_test
}  // namespace batten
