#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "batten/io/curve_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/io/table.hpp"
#include "batten/io/write_points.hpp"
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "batten/shape/transform.hpp"
#include "random.hpp"

namespace batten {
namespace io_roundtrip_test {

using testing::Random;

bool same_bits(std::span<const double> a, std::span<const double> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

Curve reread(const Curve& curve) {
    return parse_curve({"copy.json", dump_json(curve_value(curve))});
}

/// Any finite double, small and large, positive and negative alike.
double any_double(Random& random) {
    const double x = std::ldexp(random.within(-1, 1), random.whole(-1073, 1023));
    return random.whole(0, 9) == 0 ? std::copysign(0.0, x) : x;
}

TEST(WrittenPoints, ReadBackBitForBit) {
    Random random(1);
    for (int dim = 1; dim <= 4; ++dim) {
        Points points(200, dim);
        for (double& x : points.coordinates()) x = any_double(random);
        for (const Source& copy :
             {Source{"p.csv", csv_points(points, coordinate_names(dim))},
              Source{"p.csv", csv_points(points, {})}, Source{"p.json", json_points(points)},
              Source{"p.npy", npy_points(points)}}) {
            const Table table = parse_table(copy);
            EXPECT_TRUE(same_bits(table.cells.coordinates(), points.coordinates())) << copy.name;
            EXPECT_EQ(table.columns(), dim);
        }
    }
}

TEST(WrittenNames, ReadBackAsTheyAre) {
    const Points points({1, 2, 3}, 3);
    const std::vector<std::string> names{" x, \"east\"", "y;z # no", "\ttab"};
    EXPECT_EQ(parse_table({"p.csv", csv_points(points, names)}).names, names);
    const std::vector<std::string> alone{"a b"};
    EXPECT_EQ(parse_table({"p.csv", csv_points(Points(std::vector<double>{1}, 1), alone)}).names, alone);
}

Value any_value(Random& random, int depth) {
    switch (random.whole(0, depth > 0 ? 6 : 4)) {
        case 0: return nullptr;
        case 1: return random.whole(0, 1) == 1;
        case 2: return random.whole(-1000, 1000);
        case 3: return any_double(random) + 0.5 * random.within(0.1, 0.9);
        case 4: {
            std::string text;
            for (int i = random.whole(0, 9); i > 0; --i) {
                text += static_cast<char>(random.whole(0, 127));
            }
            return text;
        }
        case 5: {
            ValueList list;
            for (int i = random.whole(0, 5); i > 0; --i) list.push_back(any_value(random, depth - 1));
            return list;
        }
        default: {
            ValueMap map;
            for (int i = random.whole(0, 5); i > 0; --i) {
                map.emplace_back("key " + std::to_string(i), any_value(random, depth - 1));
            }
            return map;
        }
    }
}

/// Whole reals come back as whole numbers, which are equal as text.
TEST(WrittenJson, ReadsBackInBothStyles) {
    Random random(2);
    for (int i = 0; i < 300; ++i) {
        const Value value = any_value(random, 4);
        const std::string line = dump_json(value, JsonStyle::one_line);
        const std::string page = dump_json(value);
        EXPECT_EQ(dump_json(parse_json(line, "line"), JsonStyle::one_line), line);
        EXPECT_EQ(dump_json(parse_json(page, "page"), JsonStyle::one_line), line);
    }
}

PiecewiseCubic any_cubic(Random& random, int dim, bool closed) {
    const std::size_t pieces = static_cast<std::size_t>(random.whole(2, 9));
    Points points = random.points(pieces + 1, dim);
    for (double& x : points.coordinates()) x = std::ldexp(x, random.whole(-40, 40));
    if (closed) std::copy_n(points[0].begin(), dim, points[pieces].begin());
    // Eighths, so that parameters inside a piece are exact.
    std::vector<double> breaks{random.whole(-8, 8) / 8.0};
    while (breaks.size() <= pieces) breaks.push_back(breaks.back() + random.whole(1, 16) / 8.0);
    return PiecewiseCubic::hermite(points, random.points(pieces, dim), random.points(pieces, dim),
                                   breaks, closed);
}

TEST(CurveFile, GivesAPiecewiseCubicBackBitForBit) {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const PiecewiseCubic curve = any_cubic(random, 1 + i % 4, i % 2 == 0);
        const Curve copy = reread(curve);
        ASSERT_TRUE(copy.shape<PiecewiseCubic>());
        EXPECT_EQ(*copy.shape<PiecewiseCubic>(), curve);
    }
}

TEST(CurveFile, GivesABSplineBackBitForBit) {
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const int degree = 1 + i % 5;
        std::vector<double> knots{random.within(-1, 1)};
        for (int k = random.whole(1, 8); k > 0; --k) {
            const double next = knots.back() + random.within(0.01, 2);
            knots.insert(knots.end(), static_cast<std::size_t>(k > 1 ? random.whole(1, degree) : 1),
                         next);
        }
        const bool closed = i % 2 == 0;
        if (closed) {
            const double start = knots[0];
            knots.insert(knots.begin(), static_cast<std::size_t>(random.whole(0, degree - 1)), start);
        } else {
            const double start = knots.front(), end = knots.back();
            knots.insert(knots.begin(), static_cast<std::size_t>(degree), start);
            knots.insert(knots.end(), static_cast<std::size_t>(degree), end);
        }
        const BSplineBasis basis =
            closed ? BSplineBasis::periodic(knots, degree) : BSplineBasis(knots, degree);
        std::vector<double> weights;
        if (i % 3 == 0) {
            for (std::size_t k = 0; k < basis.size(); ++k) weights.push_back(random.within(0.1, 9));
        }
        const BSplineCurve curve(basis, random.points(basis.size(), 1 + i % 3), weights);
        const Curve copy = reread(curve);
        ASSERT_TRUE(copy.shape<BSplineCurve>());
        EXPECT_EQ(*copy.shape<BSplineCurve>(), curve);
    }
}

TEST(CurveFile, OfATrimmedCurveIsAPiecewiseCubicOfTheSamePoints) {
    Random random(5);
    const PiecewiseCubic whole = any_cubic(random, 3, false);
    const Curve part = trimmed(whole, {whole.breaks()[0] + 1e-3, whole.breaks()[1] + 1e-3});
    const Curve copy = reread(part);
    EXPECT_TRUE(copy.shape<PiecewiseCubic>());
    EXPECT_TRUE(same_bits(copy.breaks(), part.breaks()));
    for (const double t : {part.domain().lo, part.domain().middle(), part.domain().hi}) {
        const std::vector<double> p = part(t), q = copy(t);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(q[k], p[k], 1e-15 * extent(part));
    }
}

TEST(SvgPath, GivesTheSamePointsBack) {
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        const PiecewiseCubic curve = any_cubic(random, 2, i % 2 == 0);
        const Curve copy = parse_svg_path(svg_path(curve), "copy");
        ASSERT_EQ(copy.pieces(), curve.pieces());
        EXPECT_EQ(copy.is_closed(), curve.is_closed());
        for (std::size_t piece = 0; piece < curve.pieces(); ++piece) {
            const Interval span{curve.breaks()[piece], curve.breaks()[piece + 1]};
            for (const double u : {0.0, 0.25, 0.5, 0.875, 1.0}) {
                const double t = u == 1 ? span.hi : span.lo + u * span.length();
                const Jet p = Curve(curve).jet_on(piece, t, 0);
                const Jet q = copy.jet_on(piece, static_cast<double>(piece) + u, 0);
                const double near = 4e-15 * extent(curve);
                for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(q[0][k], p[0][k], near);
            }
        }
    }
}

TEST(SvgPath, OfAScaledCurveIsScaledExactly) {
    const std::string small = "M0 0C1 3 2 5 4 0A3 2 30 1 0 9 1";
    const std::string large = "M0 0C1024 3072 2048 5120 4096 0A3072 2048 30 1 0 9216 1024";
    const Curve a = scaled(parse_svg_path(small, "small"), 1024), b = parse_svg_path(large, "large");
    for (int i = 0; i <= 40; ++i) {
        const double t = a.domain().hi * (i / 40.0);
        EXPECT_EQ(a(t), b(t));
    }
}

TEST(WrittenArcs, ReadBackToTheSameChain) {
    Random random(6);
    for (int round = 0; round < 50; ++round) {
        Points joints = random.points(7, 2);
        if (round % 2 == 1) joints.push_back(joints.view()[0]);
        std::vector<double> bulges;
        while (bulges.size() + 1 < joints.size()) bulges.push_back(random.within(-2, 2));
        bulges[3] = 0;
        const ArcChain chain(joints, bulges, round % 2 == 1);
        EXPECT_EQ(*reread(chain).shape<ArcChain>(), chain);
    }
}

}  // namespace io_roundtrip_test
}  // namespace batten
