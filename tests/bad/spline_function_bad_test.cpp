#include <limits>

#include "batten/base/error.hpp"
#include "batten/shape/spline_function.hpp"
#include "errors.hpp"
#include "shared.hpp"

namespace batten {
namespace spline_function_bad_test {

using testing::code_of;
using testing::nan;

using List = std::vector<double>;

std::string code_of(List knots, List coefficients, int degree) {
    return code_of([&] { SplineFunction(knots, coefficients, degree); });
}

TEST(SplineFunctionRefuses, KnotsThatMakeNoBasis) {
    EXPECT_EQ(code_of({0, 0, 1, 1}, {1, 2}, 1), "none");
    EXPECT_EQ(code_of({0, 0, 1}, {1, 2}, 1), "spline.knots");
    EXPECT_EQ(code_of({0, 1}, {}, 1), "spline.knots");
    EXPECT_EQ(code_of({}, {}, 1), "spline.knots");
    EXPECT_EQ(code_of({0, 1, 0, 1}, {1, 2}, 1), "spline.knots");
    EXPECT_EQ(code_of({0, nan, 1, 1}, {1, 2}, 1), "spline.knots");
    EXPECT_EQ(code_of({0, 0, 0, 0}, {1, 2}, 1), "spline.knots");
    EXPECT_EQ(code_of({0, 0, 1, 1, 1, 2, 2}, {1, 2, 3, 4, 5}, 1), "spline.knots");
    EXPECT_EQ(code_of({0, 0, 1, 1}, {1, nan}, 1), "spline.coefficients");
    EXPECT_EQ(code_of({0, 1}, {1}, -1), "spline.degree");
    EXPECT_EQ(code_of({0, 1}, {1}, 26), "spline.degree");
    EXPECT_EQ(code_of({0, 0, 1e-200, 1e-200}, {0, 1e200}, 1), "number.overflow");
}

TEST(SplineFunctionRefuses, ChangesThatCannotBe) {
    const SplineFunction s({0, 0, 1, 2, 2}, {0, 1, 0}, 1);
    const double outside = 2, inside = 1;
    EXPECT_EQ(code_of([&] { insert_knots(s, {&outside, 1}); }), "spline.knots");
    const SplineFunction twice = insert_knots(s, {&inside, 1});
    EXPECT_EQ(code_of([&] { insert_knots(twice, {&inside, 1}); }), "spline.knots");
    EXPECT_EQ(code_of([&] { remove_knot(s, 0); }), "spline.knots");
    EXPECT_EQ(code_of([&] { remove_knot(s, 99); }), "spline.knots");
    EXPECT_EQ(code_of([&] { elevate_degree(s, 25); }), "spline.degree");
    EXPECT_EQ(code_of([&] { elevate_degree(s, 0); }), "spline.degree");
    EXPECT_EQ(code_of([&] { graph(twice); }), "spline.not-continuous");
    EXPECT_EQ(code_of([&] { graph(SplineFunction({0, 1}, {1}, 0)); }), "spline.not-continuous");
    EXPECT_EQ(code_of([&] { graph_cubic(elevate_degree(s, 3)); }), "spline.degree");
}

}  // namespace spline_function_bad_test
}  // namespace batten
