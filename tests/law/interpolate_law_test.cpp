#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "batten/make/interpolate.hpp"
#include "random.hpp"

namespace batten {
namespace interpolate_law_test {

using testing::Random;

struct Asked {
    std::string name;
    InterpolateOptions options;
};

Asked method(Method m, bool closed = false) {
    Asked asked{std::string(name_of(m)), {}};
    asked.options.method = m;
    asked.options.closed = closed;
    if (closed) asked.name += " closed";
    return asked;
}

Asked spline(Ends ends, Parameter parameter) {
    Asked asked = method(Method::spline);
    asked.options.ends = ends;
    asked.options.parameter = parameter;
    asked.name += " " + std::string(name_of(ends)) + " " + std::string(name_of(parameter));
    return asked;
}

std::vector<Asked> hermite_types(bool closed) {
    return {method(Method::hermite_chord, closed), method(Method::hermite_arc, closed),
            method(Method::pseudo_spline, closed)};
}

/// All methods that take any points of the plane, global ones last.
std::vector<Asked> planar_methods() {
    std::vector<Asked> all = hermite_types(false);
    for (const Asked& closed : hermite_types(true)) all.push_back(closed);
    for (const Parameter p : {Parameter::uniform, Parameter::chord, Parameter::centripetal}) {
        for (const Ends e : {Ends::natural, Ends::clamped, Ends::not_a_knot}) {
            all.push_back(spline(e, p));
        }
        all.push_back(spline(Ends::natural, p));
        all.back().options.closed = true;
        all.back().name += " closed";
    }
    all.push_back(method(Method::natural_uniform));
    all.push_back(method(Method::natural_chord));
    all.push_back(method(Method::pseudo_spline_global));
    all.push_back(method(Method::pseudo_spline_global, true));
    return all;
}

std::vector<Asked> all_methods() {
    std::vector<Asked> all = planar_methods();
    all.push_back(method(Method::pchip));
    all.push_back(method(Method::makima));
    return all;
}

bool is_function(const Asked& asked) {
    return asked.options.method == Method::pchip || asked.options.method == Method::makima;
}

/// A walk that turns by up to 150 degrees, or rises in x where the method asks for it.
Points outline(Random& random, std::size_t count, const Asked& asked) {
    Points points(count, 2);
    double x = 0, y = 0, angle = 0;
    for (std::size_t i = 0; i < count; ++i) {
        points(i, 0) = x;
        points(i, 1) = y;
        angle += random.within(-2.6, 2.6);
        const double step = random.within(0.3, 1);
        x += is_function(asked) ? step : step * std::cos(angle);
        y += step * std::sin(angle);
    }
    return points;
}

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

/// The share of a piece where curves are compared.
constexpr double shares[] = {0.0, 0.25, 0.625, 1.0};

std::vector<double> at(const Curve& curve, std::size_t piece, double share, int order = 0) {
    const Interval part = curve.piece(piece);
    const Jet jet =
        curve.jet_on(piece, share == 1 ? part.hi : part.lo + share * part.length(), order);
    return {jet[order].begin(), jet[order].end()};
}

/// Largest distance at the same places of the same pieces, in the second curve's pieces `shift`
/// later, counted around.
double distance(const Curve& a, const Curve& b, std::size_t shift = 0) {
    double largest = 0;
    for (std::size_t i = 0; i < a.pieces(); ++i) {
        for (const double share : shares) {
            const auto p = at(a, i, share), q = at(b, (i + shift) % b.pieces(), share);
            for (std::size_t k = 0; k < p.size(); ++k) {
                largest = std::max(largest, std::fabs(p[k] - q[k]));
            }
        }
    }
    return largest;
}

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

}  // namespace interpolate_law_test
}  // namespace batten
