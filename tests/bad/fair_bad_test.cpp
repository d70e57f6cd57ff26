#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "batten/base/error.hpp"
#include "batten/make/alpha.hpp"
#include "batten/make/fair.hpp"
#include "errors.hpp"
#include "random.hpp"

namespace batten {
namespace fair_bad_test {

using testing::nan;

Points arc(std::size_t count) {
    Points points(count, 2);
    for (std::size_t i = 0; i < count; ++i) {
        points(i, 0) = std::cos(0.1 * static_cast<double>(i));
        points(i, 1) = std::sin(0.1 * static_cast<double>(i));
    }
    return points;
}

std::string code_of(const Points& points, const FairOptions& options = {}) {
    return testing::code_of([&] { fair(points, options); });
}

TEST(Fairing, RefusesPointsThatAreNoRow) {
    EXPECT_EQ(code_of(arc(4)), "points.too-few");
    EXPECT_EQ(code_of(arc(5)), "none");
    Points points = arc(9);
    points(3, 1) = nan;
    EXPECT_EQ(code_of(points), "points.not-finite");
    points = arc(9);
    points(3, 0) = points(4, 0);
    points(3, 1) = points(4, 1);
    EXPECT_EQ(code_of(points), "points.repeated");
    EXPECT_EQ(code_of(Points(9, 2)), "points.all-equal");
    EXPECT_EQ(code_of(Points(9, 1)), "points.dimension");
}

TEST(Fairing, RefusesOptionsThatMakeNoSense) {
    const auto with = [](auto change) {
        FairOptions options;
        change(options);
        return code_of(arc(20), options);
    };
    EXPECT_EQ(with([](FairOptions& o) { o.alpha.value = nan; }), "option.range");
    EXPECT_EQ(with([](FairOptions& o) { o.alpha.value = 1e6; }), "option.range");
    EXPECT_EQ(with([](FairOptions& o) { o.sigma = 0; }), "option.range");
    EXPECT_EQ(with([](FairOptions& o) { o.sigma = nan; }), "option.range");
    EXPECT_EQ(with([](FairOptions& o) { o.lambda = -1; }), "option.range");
    EXPECT_EQ(with([](FairOptions& o) { o.tolerance = absolute(nan); }), "option.range");
    EXPECT_EQ(with([](FairOptions& o) { o.sweeps = 0; }), "option.range");
    EXPECT_EQ(with([](FairOptions& o) { o.window = 0; }), "option.range");
    EXPECT_EQ(with([](FairOptions& o) { o.sigma = 0.1, o.tolerance = absolute(0.05); }),
              "fair.tolerance-below-sigma");
    EXPECT_EQ(with([](FairOptions& o) { o.closed = true, o.fix_ends = FixEnds::position; }),
              "fair.closed-has-no-ends");
}

TEST(Fairing, RefusesNoiseThatFoldsThePoints) {
    testing::Random random(1);
    const Points cloud = random.points(30, 2);
    EXPECT_EQ(code_of(cloud), "fair.folds");
}

TEST(Fairing, GivesPointsInAStraightLineBack) {
    Points line(0, 2);
    for (int i = 0; i < 9; ++i) line.push_back(std::vector<double>{1.0 * i * i, 2.0 * i * i + 1});
    for (const FairEngine engine : {FairEngine::gauss_newton, FairEngine::filter}) {
        FairOptions options;
        options.engine = engine;
        const Fairing made = fair(line, options);
        EXPECT_EQ(made.points, line);
        EXPECT_EQ(made.report.status, Status::met);
        EXPECT_NE(made.report.notes.back().find("straight line"), std::string::npos);
        options.as = FairForm::arcs;
        EXPECT_TRUE(fair(line, options).curve);
    }
}

TEST(Fairing, OfARingThatRepeatsItsFirstPointSaysSo) {
    Points ring(0, 2);
    for (int i = 0; i < 41; ++i) {
        const double t = 2 * std::acos(-1.0) * (i % 40) / 40;
        ring.push_back(std::vector<double>{std::cos(t), 0.7 * std::sin(t) + 0.001 * (i % 40 % 3)});
    }
    FairOptions options;
    options.closed = true;
    const Fairing made = fair(ring, options);
    EXPECT_EQ(made.points.size(), 41u);
    EXPECT_EQ(made.points(0, 0), made.points(40, 0));
    EXPECT_NE(made.report.notes.front().find("repeats"), std::string::npos);
}

TEST(Fairing, TakesRingsOfFivePointsAndZigzags) {
    for (int n = 5; n < 12; ++n) {
        Points ring(0, 2), zigzag(0, 2);
        for (int i = 0; i < n; ++i) {
            const double t = 2 * std::acos(-1.0) * i / n;
            ring.push_back(std::vector<double>{std::cos(t), 0.8 * std::sin(t)});
            zigzag.push_back(std::vector<double>{1.0 * (i % 2), 1e-3 * i});
        }
        FairOptions options;
        options.closed = true;
        options.sigma = 0.01;
        const Fairing made = fair(ring, options);
        EXPECT_LT(made.report.max_displacement, 0.1);
        options = {};
        options.engine = FairEngine::filter;
        EXPECT_LT(fair(zigzag, options).report.max_displacement, 10);
    }
}

TEST(AlphaFromPoints, RefusesTooFewPoints) {
    const auto code = [](const Points& points) {
        return testing::code_of([&] { alpha_of(points); });
    };
    EXPECT_EQ(code(arc(7)), "points.too-few");
    EXPECT_EQ(code(arc(8)), "none");
    EXPECT_EQ(code(Points(9, 3)), "points.dimension");
}

TEST(Fairing, RefusesOptionsWithoutWhatTheyBelongTo) {
    const auto with = [](auto change) {
        FairOptions options;
        change(options);
        return code_of(arc(20), options);
    };
    EXPECT_EQ(with([](FairOptions& o) { o.window = 5; }), "fair.options");
    EXPECT_EQ(with([](FairOptions& o) { o.sweeps = 5; }), "fair.options");
    EXPECT_EQ(with([](FairOptions& o) { o.split = true; }), "fair.options");
    EXPECT_EQ(with([](FairOptions& o) { o.spacing = FairSpacing::kept; }), "fair.options");
    EXPECT_EQ(with([](FairOptions& o) { o.beta = 1; }), "fair.options");
    EXPECT_EQ(with([](FairOptions& o) { o.engine = FairEngine::filter, o.lambda = 1; }),
              "fair.options");
}

}  // namespace fair_bad_test
}  // namespace batten
