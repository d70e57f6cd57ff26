#include <gtest/gtest.h>

#include <cmath>

#include "batten/io/curve_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/measure/coordinate.hpp"
#include "batten/shape/spline_graph.hpp"
#include "errors.hpp"

namespace batten {
namespace spline_graph_test {

/// 2 t up to 1, then from -1 up to 5 at 3.
SplineFunction saw() { return {{0, 0, 1, 1, 3, 3}, {0, 2, -1, 5}, 1}; }

/// A quadratic that jumps at 0.4, its ends not clamped, with a corner at 0.7.
SplineFunction uneven() {
    return {{-0.2, -0.1, 0, 0.4, 0.4, 0.4, 0.7, 0.7, 1, 1.2, 1.3}, {1, 2, 3, -1, 0.5, 2, 1, 3}, 2};
}

TEST(SplineGraph, HasBothLimitsAtAJump) {
    const Curve curve = graph_in_parts(saw());
    ASSERT_TRUE(has_jumps(curve));
    EXPECT_EQ(curve(1.0)[1], -1);
    EXPECT_EQ(curve.jet_on(0, 1, 0)[0][1], 2);
    const Jet jet = curve.jet(2, 2);
    EXPECT_EQ(jet[0][0], 2);
    EXPECT_EQ(jet[0][1], 2);
    EXPECT_EQ(jet[1][0], 1);
    EXPECT_EQ(jet[1][1], 3);
    EXPECT_EQ(jet[2][1], 0);
    EXPECT_EQ(integral(curve, 1, {0, 3}), 1 + 4);
    EXPECT_EQ(extrema(graph_in_parts(saw()), 1).size(), 0u);
}

TEST(SplineGraph, ComesBackFromItsFileBitForBit) {
    for (const SplineFunction& spline : {saw(), uneven(), SplineFunction({0, 1, 3}, {4, -2}, 0)}) {
        const Curve curve = graph_in_parts(spline);
        const std::string text = dump_json(curve_value(curve));
        const Curve back = parse_curve({"jumps.json", text});
        ASSERT_NE(back.shape<SplineGraph>(), nullptr);
        EXPECT_EQ(*back.shape<SplineGraph>(), *curve.shape<SplineGraph>());
        EXPECT_EQ(dump_json(curve_value(back)), text);
        for (const double x : {0.05, 0.39, 0.4, 0.9}) EXPECT_NEAR(back(x)[1], spline(x), 1e-14);
    }
}

TEST(SplineGraph, WithoutJumpsIsACurveLikeAnyOther) {
    const SplineFunction corner({0, 0, 1, 2, 2}, {0, 1, 0}, 1);
    EXPECT_FALSE(has_jumps(graph_in_parts(corner)));
    const Curve read = parse_curve({"c.json", R"({"format": "batten.curve/1",
        "kind": "b-spline-graph", "degree": 1, "knots": [0, 0, 1, 2, 2],
        "coefficients": [0, 1, 0]})"});
    EXPECT_FALSE(has_jumps(read));
    EXPECT_EQ(read(0.5)[1], 0.5);
    EXPECT_EQ(parts_between_jumps(read).size(), 1u);
}

TEST(SplineGraph, IsTheCurvesBetweenItsJumps) {
    for (const SplineFunction& spline : {saw(), uneven(), SplineFunction({0, 1, 3}, {4, -2}, 0)}) {
        const std::vector<Curve> parts = parts_between_jumps(graph_in_parts(spline));
        ASSERT_EQ(parts.size(), 2u);
        EXPECT_EQ(parts[0].domain().hi, parts[1].domain().lo);
        for (const Curve& part : parts) {
            for (const double u : {0.1, 0.5, 0.9}) {
                const double t = part.domain().lo + u * part.domain().length();
                EXPECT_NEAR(part(t)[0], t, 1e-15);
                EXPECT_NEAR(part(t)[1], spline(t), 1e-14);
            }
        }
    }
}

TEST(SplineGraph, IsNoPathOfAPicture) {
    EXPECT_EQ(testing::code_of([] { svg_path(graph_in_parts(saw())); }), "curve.not-exact");
}

}  // namespace spline_graph_test
}  // namespace batten
