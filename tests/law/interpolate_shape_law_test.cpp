#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "interpolate_methods.hpp"

namespace batten {
namespace interpolate_shape_law_test {

using namespace testing;

TEST(Interpolate, PassesThroughItsPointsBitForBit) {
    Random random(1);
    for (const Asked& asked : all_methods()) {
        const Points points = outline(random, 8, asked);
        const Curve curve = curve_through(points, asked.options);
        ASSERT_EQ(curve.pieces(), asked.options.closed ? 8u : 7u) << asked.name;
        EXPECT_EQ(curve.is_closed(), asked.options.closed) << asked.name;
        for (std::size_t i = 0; i < curve.pieces(); ++i) {
            for (int k = 0; k < 2; ++k) {
                const std::size_t axis = static_cast<std::size_t>(k);
                EXPECT_EQ(at(curve, i, 0)[axis], points(i, k)) << asked.name;
                EXPECT_EQ(at(curve, i, 1)[axis], points((i + 1) % 8, k)) << asked.name;
            }
        }
    }
}

/// How far from a moved point the spans change: this many before and behind it.
std::size_t reach(Method m) { return m == Method::makima ? 3 : 2; }

TEST(Interpolate, ByLocalMethodsChangesOnlyTheSpansNearAMovedPoint) {
    Random random(9);
    std::vector<Asked> local = hermite_types(false);
    for (const Asked& closed : hermite_types(true)) local.push_back(closed);
    local.push_back(method(Method::pchip));
    local.push_back(method(Method::makima));
    for (const Asked& asked : local) {
        const Points points = outline(random, 12, asked);
        const Curve before = curve_through(points, asked.options);
        for (const std::size_t moved : {0u, 1u, 5u, 11u}) {
            Points other(points);
            other(moved, 0) += 0.0625;
            other(moved, 1) += 0.125;
            const Curve after = curve_through(other, asked.options);
            for (std::size_t i = 0; i < before.pieces(); ++i) {
                const std::size_t ahead = (i + 12 - moved) % 12;  // spans from the moved point on
                const std::size_t near = reach(asked.options.method);
                const bool may_change = asked.options.closed
                                            ? ahead < near || ahead + near >= 12
                                            : i + near >= moved && i < moved + near;
                const bool is_same = at(before, i, 0.25) == at(after, i, 0.25) &&
                                     at(before, i, 0.75, 1) == at(after, i, 0.75, 1);
                EXPECT_TRUE(is_same || may_change) << asked.name << ' ' << moved << ' ' << i;
                if (i == moved) {
                    EXPECT_FALSE(is_same) << asked.name;
                }
            }
        }
    }
}

TEST(Interpolate, BySplinesIsTwiceDifferentiable) {
    Random random(10);
    for (const Asked& asked : planar_methods()) {
        const bool is_spline = asked.options.method == Method::spline ||
                               asked.options.method == Method::natural_uniform ||
                               asked.options.method == Method::natural_chord;
        if (!is_spline) continue;
        const Points points = outline(random, 10, asked);
        const Curve curve = curve_through(points, asked.options);
        const std::size_t pieces = curve.pieces();
        for (std::size_t i = asked.options.closed ? 0 : 1; i < pieces; ++i) {
            for (int order = 1; order <= 2; ++order) {
                const auto left = at(curve, (i + pieces - 1) % pieces, 1, order);
                const auto right = at(curve, i, 0, order);
                ASSERT_NEAR(left[0], right[0], 1e-12) << asked.name;
                ASSERT_NEAR(left[1], right[1], 1e-12) << asked.name;
            }
        }
    }
}

TEST(Interpolate, EndsAsAsked) {
    Random random(11);
    Asked asked = spline(Ends::natural, Parameter::chord);
    const Points points = outline(random, 10, asked);
    const Curve natural = curve_through(points, asked.options);
    EXPECT_EQ(at(natural, 0, 0, 2), (std::vector<double>{0, 0}));
    EXPECT_NEAR(at(natural, 8, 1, 2)[0], 0, 1e-14);
    asked.options.ends = Ends::not_a_knot;
    const Curve smooth = curve_through(points, asked.options);
    EXPECT_NEAR(at(smooth, 0, 0, 3)[0], at(smooth, 1, 0, 3)[0], 1e-12);
    EXPECT_NEAR(at(smooth, 7, 0, 3)[1], at(smooth, 8, 0, 3)[1], 1e-12);
    asked.options.ends = Ends::clamped;
    asked.options.tangent = {{0, {0.75}}, {9, {-2}}};
    const Curve clamped = curve_through(points, asked.options);
    EXPECT_NEAR(at(clamped, 0, 0, 1)[0], std::cos(0.75), 1e-14);
    EXPECT_NEAR(at(clamped, 0, 0, 1)[1], std::sin(0.75), 1e-14);
    EXPECT_NEAR(at(clamped, 8, 1, 1)[0], std::cos(-2), 1e-13);
    EXPECT_NEAR(at(clamped, 8, 1, 1)[1], std::sin(-2), 1e-13);
}

TEST(Interpolate, IsStraightBetweenTwoPoints) {
    const Points points({-1, 2, 2.7, 3.1}, 2);
    for (const Asked& asked : all_methods()) {
        if (asked.options.closed) continue;
        const Curve curve = curve_through(points, asked.options);
        ASSERT_EQ(curve.pieces(), 1u);
        EXPECT_EQ(at(curve, 0, 0.5, 2), (std::vector<double>{0, 0})) << asked.name;
        EXPECT_EQ(at(curve, 0, 0.5, 3), (std::vector<double>{0, 0})) << asked.name;
    }
}

TEST(Interpolate, IsStraightThroughPointsOfALine) {
    const Points points({0, 0, 1, 2, 1.5, 3, 4, 8, 4.25, 8.5}, 2);
    for (const Asked& asked : all_methods()) {
        if (asked.options.closed) continue;
        const Curve curve = curve_through(points, asked.options);
        for (std::size_t i = 0; i < curve.pieces(); ++i) {
            const auto p = at(curve, i, 0.3);
            EXPECT_NEAR(p[1], 2 * p[0], 1e-14) << asked.name;
        }
    }
}

TEST(Interpolate, IsFiniteAtExactFoldBacks) {
    const Points line({0, 0, 2, 1, 0, 0, 2, 1, 0.5, 0.25}, 2);
    for (const Asked& asked : planar_methods()) {
        const Curve curve = curve_through(line, asked.options);
        for (std::size_t i = 0; i < curve.pieces(); ++i) {
            for (const double x : at(curve, i, 0.4)) EXPECT_LE(std::fabs(x), 4) << asked.name;
        }
    }
}

TEST(Interpolate, SplitsAtCorners) {
    Random random(12);
    for (Asked asked : hermite_types(false)) {
        const Points points = outline(random, 9, asked);
        asked.options.corner = {4};
        const Curve curve = curve_through(points, asked.options);
        asked.options.corner.clear();
        const Curve first = curve_through(points.view().part(0, 5), asked.options);
        const Curve second = curve_through(points.view().part(4, 5), asked.options);
        for (const double share : shares) {
            for (std::size_t i = 0; i < 4; ++i) {
                EXPECT_EQ(at(curve, i, share), at(first, i, share)) << asked.name;
                EXPECT_EQ(at(curve, i + 4, share), at(second, i, share)) << asked.name;
            }
        }
    }
    for (Asked asked : hermite_types(true)) {
        const Points points = outline(random, 6, asked);
        asked.options.corner = {2};
        const Curve curve = curve_through(points, asked.options);
        Points open(2);
        for (std::size_t i = 0; i <= 6; ++i) open.push_back(points[(i + 2) % 6]);
        asked.options.corner.clear();
        asked.options.closed = false;
        EXPECT_EQ(distance(curve_through(open, asked.options), curve, 2), 0) << asked.name;
    }
}

TEST(Interpolate, RunsInFixedDirections) {
    Random random(13);
    for (const bool closed : {false, true}) {
        for (Asked asked : hermite_types(closed)) {
            const Points points = outline(random, 7, asked);
            asked.options.tangent = {{0, {2.5}}, {3, {-0.5}}};
            const Curve curve = curve_through(points, asked.options);
            for (const FixedTangent& tangent : asked.options.tangent) {
                const std::size_t i = static_cast<std::size_t>(tangent.index);
                const auto out = at(curve, i, 0, 1);
                EXPECT_NEAR(std::atan2(out[1], out[0]), tangent.angle.radians, 1e-14);
                if (i == 0 && !closed) continue;
                const auto in = at(curve, (i + 6) % 7, 1, 1);
                EXPECT_NEAR(std::atan2(in[1], in[0]), tangent.angle.radians, 1e-14) << asked.name;
            }
        }
    }
}

TEST(Interpolate, KeepsAPartAsItWas) {
    Random random(14);
    for (Asked asked : all_methods()) {
        const Points points = outline(random, 8, asked);
        const Curve whole = curve_through(points, asked.options);
        asked.options.part = {2, 5};
        const Curve part = curve_through(points, asked.options);
        ASSERT_EQ(part.pieces(), 3u);
        EXPECT_FALSE(part.is_closed());
        EXPECT_EQ(part.domain(), (Interval{whole.breaks()[2], whole.breaks()[5]}));
        for (std::size_t i = 0; i < 3; ++i) {
            for (const double share : shares) {
                EXPECT_EQ(at(part, i, share), at(whole, i + 2, share)) << asked.name;
            }
        }
    }
}

TEST(Interpolate, IsMonotoneByPchip) {
    Random random(15);
    InterpolateOptions options;
    options.method = Method::pchip;
    for (int trial = 0; trial < 50; ++trial) {
        Points points(10, 2);
        for (std::size_t i = 1; i < 10; ++i) {
            points(i, 0) = points(i - 1, 0) + random.within(0.05, 1);
            points(i, 1) = points(i - 1, 1) + (random.whole(0, 3) == 0 ? 0 : random.within(0, 2));
        }
        const Curve curve = curve_through(points, options);
        for (std::size_t i = 0; i < 9; ++i) {
            for (double share = 0; share <= 1; share += 0.0625) {
                ASSERT_GE(at(curve, i, share, 1)[1], -1e-14);
            }
        }
    }
}

TEST(Interpolate, InSpaceDoesAsInThePlane) {
    Random random(16);
    // The plane spanned by two unit vectors across each other.
    const double u[3] = {2 / 3., -1 / 3., 2 / 3.}, v[3] = {1 / 3., -2 / 3., -2 / 3.};
    for (const Asked& asked : planar_methods()) {
        if (asked.options.method == Method::pseudo_spline_global) continue;
        const Points points = outline(random, 7, asked);
        Points lifted(7, 3);
        for (std::size_t i = 0; i < 7; ++i) {
            for (int k = 0; k < 3; ++k) lifted(i, k) = points(i, 0) * u[k] + points(i, 1) * v[k];
        }
        const Curve plane = curve_through(points, asked.options);
        const Curve space = curve_through(lifted, asked.options);
        for (std::size_t i = 0; i < plane.pieces(); ++i) {
            const auto p = at(plane, i, 0.375), q = at(space, i, 0.375);
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_NEAR(q[k], p[0] * u[k] + p[1] * v[k], 1e-10) << asked.name;
            }
        }
    }
}

}  // namespace interpolate_shape_law_test
}  // namespace batten
