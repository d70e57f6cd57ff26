#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "interpolate_methods.hpp"

namespace batten {
namespace interpolate_law_test {

using namespace testing;

template <class Map>
Points mapped(const Points& points, Map&& map) {
    Points result(points);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const auto [x, y] = map(points(i, 0), points(i, 1));
        result(i, 0) = x;
        result(i, 1) = y;
    }
    return result;
}

struct Plane {
    double x, y;
};

TEST(Interpolate, ScalesExactlyWithPowersOfTwo) {
    Random random(2);
    for (const Asked& asked : all_methods()) {
        const Points points = outline(random, 7, asked);
        const Curve curve = curve_through(points, asked.options);
        for (const double factor : {0x1p-60, 0x1p-1, 0x1p200}) {
            const Curve scaled = curve_through(mapped(points,
                                                      [&](double x, double y) {
                                                          return Plane{factor * x, factor * y};
                                                      }),
                                               asked.options);
            for (std::size_t i = 0; i < curve.pieces(); ++i) {
                for (const double share : shares) {
                    auto want = at(curve, i, share);
                    for (double& x : want) x *= factor;
                    ASSERT_EQ(at(scaled, i, share), want) << asked.name;
                }
            }
        }
    }
}

TEST(Interpolate, MirrorsExactly) {
    Random random(3);
    for (const Asked& asked : all_methods()) {
        const Points points = outline(random, 7, asked);
        const Curve curve = curve_through(points, asked.options);
        const Curve mirrored = curve_through(mapped(points,
                                                    [](double x, double y) {
                                                        return Plane{x, -y};
                                                    }),
                                             asked.options);
        for (std::size_t i = 0; i < curve.pieces(); ++i) {
            for (const double share : shares) {
                auto want = at(curve, i, share);
                want[1] = -want[1];
                ASSERT_EQ(at(mirrored, i, share), want) << asked.name;
            }
        }
    }
}

TEST(Interpolate, TurnsAndMovesWithItsPoints) {
    Random random(4);
    const double c = std::cos(0.7), s = std::sin(0.7);
    const auto move = [&](double x, double y) {
        return Plane{3 * (c * x - s * y) + 5, 3 * (s * x + c * y) - 2};
    };
    for (const Asked& asked : planar_methods()) {
        const Points points = outline(random, 7, asked);
        const Curve curve = curve_through(points, asked.options);
        const Curve moved = curve_through(mapped(points, move), asked.options);
        for (std::size_t i = 0; i < curve.pieces(); ++i) {
            for (const double share : shares) {
                const auto p = at(curve, i, share), q = at(moved, i, share);
                const auto [x, y] = move(p[0], p[1]);
                ASSERT_NEAR(q[0], x, 1e-9) << asked.name;
                ASSERT_NEAR(q[1], y, 1e-9) << asked.name;
            }
        }
    }
}

TEST(Interpolate, ByUniformParametersFollowsEveryAffineMap) {
    Random random(5);
    const auto shear = [](double x, double y) { return Plane{2 * x + 3 * y + 1, 5 * y - x}; };
    for (const Asked& asked : planar_methods()) {
        if (asked.options.parameter != Parameter::uniform &&
            asked.options.method != Method::natural_uniform) {
            continue;
        }
        const Points points = outline(random, 9, asked);
        const Curve curve = curve_through(points, asked.options);
        const Curve sheared = curve_through(mapped(points, shear), asked.options);
        for (std::size_t i = 0; i < curve.pieces(); ++i) {
            const auto p = at(curve, i, 0.3), q = at(sheared, i, 0.3);
            const auto [x, y] = shear(p[0], p[1]);
            ASSERT_NEAR(q[0], x, 1e-13) << asked.name;
            ASSERT_NEAR(q[1], y, 1e-13) << asked.name;
        }
    }
}

TEST(Interpolate, OfFunctionsFollowsStretchedAxes) {
    Random random(6);
    const auto stretch = [](double x, double y) { return Plane{3 * x - 7, -5 * y}; };
    for (const Method m : {Method::pchip, Method::makima}) {
        const Asked asked = method(m);
        const Points points = outline(random, 12, asked);
        const Curve curve = curve_through(points, asked.options);
        const Curve stretched = curve_through(mapped(points, stretch), asked.options);
        for (std::size_t i = 0; i < curve.pieces(); ++i) {
            const auto p = at(curve, i, 0.3), q = at(stretched, i, 0.3);
            ASSERT_NEAR(q[0], 3 * p[0] - 7, 1e-13) << asked.name;
            ASSERT_NEAR(q[1], -5 * p[1], 1e-12) << asked.name;
        }
    }
}

TEST(Interpolate, RunsBackwardsThroughReversedPoints) {
    Random random(7);
    for (const Asked& asked : planar_methods()) {
        const Points points = outline(random, 8, asked);
        Points backwards(2);
        for (std::size_t i = points.size(); i-- > 0;) backwards.push_back(points[i]);
        const Curve curve = curve_through(points, asked.options);
        const Curve reversed = curve_through(backwards, asked.options);
        const std::size_t pieces = curve.pieces();
        for (std::size_t i = 0; i < pieces; ++i) {
            // Of a closed curve the span back to the first point stays the last one.
            const std::size_t other = (2 * pieces - (asked.options.closed ? 2 : 1) - i) % pieces;
            for (const double share : shares) {
                const auto p = at(curve, i, share), q = at(reversed, other, 1 - share);
                ASSERT_NEAR(p[0], q[0], 1e-11) << asked.name << ' ' << i;
                ASSERT_NEAR(p[1], q[1], 1e-11) << asked.name << ' ' << i;
            }
        }
    }
}

TEST(Interpolate, OfAClosedCurveMayStartAnywhere) {
    Random random(8);
    for (const Asked& asked : planar_methods()) {
        if (!asked.options.closed) continue;
        const Points points = outline(random, 9, asked);
        Points shifted(2);
        for (std::size_t i = 0; i < 9; ++i) shifted.push_back(points[(i + 4) % 9]);
        const bool is_local = asked.options.method != Method::spline &&
                              asked.options.method != Method::pseudo_spline_global;
        const double error = distance(curve_through(shifted, asked.options),
                                      curve_through(points, asked.options), 4);
        ASSERT_LE(error, is_local ? 0 : 1e-8) << asked.name;
    }
}

}  // namespace interpolate_law_test
}  // namespace batten
