#include <cmath>
#include <numbers>

#include "batten/make/arcs.hpp"
#include "batten/make/densify.hpp"
#include "batten/make/interpolate.hpp"
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "shared.hpp"

namespace batten {
namespace interpolate_windows_test {

constexpr double pi = std::numbers::pi;

/// The paper's half ellipse.
Points ellipse(int n) {
    Points points(0, 2);
    for (int i = 0; i <= n; ++i) {
        points.push_back(std::array{2 * std::cos(pi * i / n), std::sin(pi * i / n)});
    }
    return points;
}

Interpolation through(const Points& points, Method method) {
    InterpolateOptions options;
    options.method = method;
    return interpolate(points, options);
}

TEST(Lagrange, InterpolatesAsDensifyDoes) {
    for (const int degree : {2, 3}) {
        DensifyOptions options;
        options.degree = degree;
        options.between = 0;
        const Densified made = densify(ellipse(6), options);
        const Interpolation result =
            through(ellipse(6), degree == 2 ? Method::lagrange_2 : Method::lagrange_3);
        EXPECT_EQ(*result.curve.shape<PiecewiseCubic>(), *made.curve.shape<PiecewiseCubic>());
        ASSERT_EQ(result.report.notes.size(), 1u);
        EXPECT_NE(result.report.notes[0].find("the tangent jumps"), std::string::npos);
    }
}

TEST(Lagrange, TakesTheRuleForItsParameters) {
    const Points uneven({0, 0, 1, 2, 5, 3, 6, 0, 6.5, 0.5, 12, 1}, 2);
    for (const Parameter rule : {Parameter::uniform, Parameter::chord, Parameter::centripetal}) {
        InterpolateOptions options;
        options.method = Method::lagrange_3;
        options.parameter = rule;
        DensifyOptions same;
        same.between = 0;
        same.parameter = rule == Parameter::uniform ? LagrangeParameter::index
                         : rule == Parameter::chord ? LagrangeParameter::chord
                                                    : LagrangeParameter::centripetal;
        EXPECT_EQ(*interpolate(uneven, options).curve.shape<PiecewiseCubic>(),
                  *densify(uneven, same).curve.shape<PiecewiseCubic>());
    }
    const Curve unasked = through(uneven, Method::lagrange_3).curve;
    EXPECT_EQ(unasked.domain().hi, 5);
}

TEST(Lagrange, TakesGivenParametersAndFewPoints) {
    InterpolateOptions options;
    options.method = Method::lagrange_3;
    options.parameter_values = {0, 1, 4, 9, 16};
    const Points parabola({0, 0, 1, 1, 4, 16, 9, 81, 16, 256}, 2);  // y = t^2, x = t
    const Curve curve = interpolate(parabola, options).curve;
    EXPECT_NEAR(curve(6.5)[1], 6.5 * 6.5, 1e-12);
    EXPECT_EQ(through(Points({0, 0, 2, 2}, 2), Method::lagrange_3).curve(0.5)[0], 1);
    const Interpolation three = through(Points({0, 0, 1, 1, 2, 0}, 2), Method::lagrange_3);
    EXPECT_EQ(three.curve(0.5)[1], 0.75);
    EXPECT_EQ(three.report.notes.size(), 1u);
}

TEST(ArcChainMethod, InterpolatesAsArcsDoes) {
    InterpolateOptions options;
    options.method = Method::arc_chain;
    EXPECT_EQ(*interpolate(ellipse(6), options).curve.shape<ArcChain>(),
              arcs(ellipse(6), {}).chain);
    options.tangent = {{0, {pi / 2}}};
    ArcsOptions start;
    start.start_angle = Angle{pi / 2};
    const Interpolation result = interpolate(ellipse(6), options);
    EXPECT_EQ(*result.curve.shape<ArcChain>(), arcs(ellipse(6), start).chain);
    EXPECT_NEAR(result.report.length, result.curve.breaks().back(), 1e-9);
    EXPECT_NEAR(result.report.tangent_angles->front(), pi / 2, 1e-12);
}

TEST(ArcChainMethod, KeepsThePartAskedFor) {
    InterpolateOptions options;
    options.method = Method::arc_chain;
    const ArcChain whole = arcs(ellipse(6), {}).chain;
    options.part = IndexRange{1, 4};
    const Interpolation result = interpolate(ellipse(6), options);
    const ArcChain* part = result.curve.shape<ArcChain>();
    ASSERT_NE(part, nullptr);
    ASSERT_EQ(part->arcs(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(part->arc(i), whole.arc(i + 1));
}

}  // namespace interpolate_windows_test
}  // namespace batten
