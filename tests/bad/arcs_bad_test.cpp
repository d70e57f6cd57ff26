#include <functional>
#include <limits>

#include "batten/base/error.hpp"
#include "batten/make/arcs.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "errors.hpp"
#include "shared.hpp"

namespace batten {
namespace arcs_bad_test {

using testing::code_of;
using testing::inf;
using testing::nan;

const Points good({0, 0, 1, 1, 2, 1, 3, 0}, 2);

std::string points_code(const Points& points, bool closed = false) {
    ArcsOptions options;
    options.closed = closed;
    return code_of([&] { arcs(points, options); });
}

std::string option_code(const std::function<void(ArcsOptions&)>& change) {
    ArcsOptions options;
    change(options);
    return code_of([&] { arcs(good, options); });
}

TEST(ArcsBad, PointsAreNamed) {
    EXPECT_EQ(points_code(Points(2)), "points.too-few");
    EXPECT_EQ(points_code(Points({0, 0}, 2)), "points.too-few");
    EXPECT_EQ(points_code(Points({0, 0, 0, 0, 0, 0}, 2)), "points.all-equal");
    EXPECT_EQ(points_code(Points({0, 0, 1, 1}, 2), true), "points.too-few");
    EXPECT_EQ(points_code(Points({0, 0, 1, 1, 0, 0}, 2), true), "points.too-few");
    EXPECT_EQ(points_code(Points({0, 0, 1, nan, 2, 0}, 2)), "points.not-finite");
    EXPECT_EQ(points_code(Points({0, 0, inf, 0, 2, 0}, 2)), "points.not-finite");
    EXPECT_EQ(points_code(Points({0, 0, 0, 1, 1, 1}, 3)), "points.dimension");
    EXPECT_EQ(points_code(Points({-1.7e308, 0, 0, 1, 1.7e308, 0}, 2)), "number.overflow");
}

TEST(ArcsBad, OptionsAreNamed) {
    for (const double x : {0.0, -1.0, nan, inf}) {
        EXPECT_EQ(option_code([&](auto& o) { o.tolerance = absolute(x); }), "option.range");
        EXPECT_EQ(option_code([&](auto& o) { o.tolerance = relative(x); }), "option.range");
        EXPECT_EQ(option_code([&](auto& o) { o.max_radius = x; }), "option.range");
    }
    EXPECT_EQ(option_code([](auto& o) { o.start_angle = Angle{nan}; }), "option.range");
    EXPECT_EQ(option_code([](auto& o) {
                  o.start_angle = Angle{0};
                  o.start_normal = Angle{1};
              }),
              "arcs.start-twice");
    EXPECT_EQ(option_code([](auto& o) { o.tangent = {{4, {0}}}; }), "arcs.tangent-index");
    EXPECT_EQ(option_code([](auto& o) { o.tangent = {{-1, {0}}}; }), "arcs.tangent-index");
    EXPECT_EQ(option_code([](auto& o) { o.tangent = {{1, {nan}}}; }), "arcs.tangent-index");
    EXPECT_EQ(option_code([](auto& o) {
                  o.tangent = {{1, {0}}};
                  o.method = ArcMethod::chain;
              }),
              "arcs.tangent-not-taken");
}

TEST(ArcsBad, AChordStraightAgainstTheStartIsNamed) {
    ArcsOptions options;
    options.start_angle = Angle{0};
    EXPECT_EQ(code_of([&] { arcs(Points({0, 0, -1, 0, -2, 1}, 2), options); }),
              "arcs.chord-against-start");
}

TEST(ArcsBad, CurvesAreNamed) {
    const Curve space = PiecewiseCubic::hermite(Points({0, 0, 0, 1, 1, 1}, 3), Points({1, 0, 0}, 3),
                                                Points({1, 0, 0}, 3), {0, 1}, false);
    EXPECT_EQ(code_of([&] { arcs(space, {}); }), "curve.dimension");
    const Curve point = PiecewiseCubic::hermite(Points({1, 1, 1, 1}, 2), Points({0, 0}, 2),
                                                Points({0, 0}, 2), {0, 1}, false);
    for (const bool by_tolerance : {false, true}) {
        ArcsOptions options;
        if (by_tolerance) options.tolerance = absolute(1);
        EXPECT_EQ(code_of([&] { arcs(point, options); }), "curve.one-point");
    }
    const Curve line = PiecewiseCubic::hermite(Points({0, 0, 1, 0}, 2), Points({1, 0}, 2),
                                               Points({1, 0}, 2), {0, 1}, false);
    ArcsOptions options;
    options.tangent = {{0, {0}}};
    EXPECT_EQ(code_of([&] { arcs(line, options); }), "arcs.tangent-not-taken");
    options.tangent.clear();
    options.start_angle = Angle{0};
    EXPECT_EQ(code_of([&] { arcs(line, options); }), "arcs.start-not-taken");
    EXPECT_EQ(arcs(line, {}).report.lines, 1u);
}

TEST(ArcChainBad, ChainsAreNamed) {
    const auto code = [](Points joints, std::vector<double> bulges, bool closed) {
        return code_of([&] { ArcChain(std::move(joints), std::move(bulges), closed); });
    };
    EXPECT_EQ(code(Points({0, 0, 1, 0}, 2), {}, false), "curve.arcs");
    EXPECT_EQ(code(Points({0, 0, 1, 0}, 2), {0, 0}, false), "curve.arcs");
    EXPECT_EQ(code(Points({0, 0, 1, 0}, 2), {nan}, false), "curve.arcs");
    EXPECT_EQ(code(Points({0, 0, 1, 0}, 2), {inf}, false), "curve.arcs");
    EXPECT_EQ(code(Points({0, 0, 1, 0, 1, 1}, 2), {0, 0}, true), "curve.arcs");
    EXPECT_EQ(code(Points({0, 0, 0, 0}, 2), {0}, false), "points.all-equal");
    EXPECT_EQ(code(Points({0, 0, 1, 0, 1, 0}, 2), {0, 0}, false), "points.repeated");
    EXPECT_EQ(code(Points({0, 0, 1, nan}, 2), {0}, false), "points.not-finite");
    EXPECT_EQ(code(Points({0, 0}, 2), {}, false), "points.too-few");
    EXPECT_EQ(code(Points({0, 0, 0, 1, 1, 1}, 3), {0}, false), "points.dimension");
    EXPECT_EQ(code(Points({0, 0, 1e300, 0, 1e300, 1e-300}, 2), {0, 0}, false), "curve.arcs");
}

}  // namespace arcs_bad_test
}  // namespace batten
