#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/shape/bspline.hpp"
#include "errors.hpp"

namespace batten {
namespace bspline_bad_test {

using testing::code_of;
using testing::inf;
using testing::nan;

std::string basis_code(std::vector<double> knots, int degree) {
    return code_of([&] { BSplineBasis(knots, degree); });
}

std::string periodic_code(std::vector<double> knots, int degree) {
    return code_of([&] { BSplineBasis::periodic(knots, degree); });
}

const BSplineBasis line = BSplineBasis::over(std::vector<double>{0, 1}, 1);

TEST(BadBSplineBasis, OfAnImpossibleDegreeIsRefused) {
    EXPECT_EQ(basis_code({0, 1}, -1), "bspline.degree");
    EXPECT_EQ(basis_code({0, 1}, 26), "bspline.degree");
    EXPECT_EQ(periodic_code({0, 1}, 0), "bspline.degree");
}

TEST(BadBSplineBasis, OfImpossibleKnotsIsRefused) {
    EXPECT_EQ(basis_code({}, 0), "bspline.knots");
    EXPECT_EQ(basis_code({0}, 0), "bspline.knots");
    EXPECT_EQ(basis_code({1, 1}, 0), "bspline.knots");
    EXPECT_EQ(basis_code({1, 0}, 0), "bspline.knots");
    EXPECT_EQ(basis_code({0, nan}, 0), "bspline.knots");
    EXPECT_EQ(basis_code({0, inf}, 0), "bspline.knots");
    EXPECT_EQ(basis_code({-1.5e308, 1.5e308}, 0), "bspline.knots");
    EXPECT_EQ(basis_code({0, 0, 1}, 1), "bspline.knots");
    EXPECT_EQ(basis_code({0, 0, 1, 1, 1}, 1), "bspline.knots");
    EXPECT_EQ(basis_code({0, 0, 1, 1, 2, 2}, 1), "bspline.knots");
    EXPECT_EQ(basis_code({0, 1, 1, 2}, 0), "bspline.knots");
    EXPECT_EQ(periodic_code({0, 1, 1}, 2), "bspline.knots");
    EXPECT_EQ(periodic_code({0, 0, 0, 1}, 2), "bspline.knots");
}

TEST(BadBSplineCurve, IsRefusedAtBirth) {
    EXPECT_EQ(code_of([] {
                  BSplineCurve(BSplineBasis({0, 1}, 0), Points(1, 2));
              }),
              "bspline.degree");
    EXPECT_EQ(code_of([] { BSplineCurve(line, Points(3, 2)); }), "bspline.control-points");
    EXPECT_EQ(code_of([] { BSplineCurve(line, Points({0, 0, nan, 1}, 2)); }), "points.not-finite");
    const Points ends({0, 0, 1, 1}, 2);
    EXPECT_EQ(code_of([&] { BSplineCurve(line, ends, {1}); }), "bspline.weights");
    EXPECT_EQ(code_of([&] { BSplineCurve(line, ends, {1, 0}); }), "bspline.weights");
    EXPECT_EQ(code_of([&] { BSplineCurve(line, ends, {1, -1}); }), "bspline.weights");
    EXPECT_EQ(code_of([&] { BSplineCurve(line, ends, {1, inf}); }), "bspline.weights");
}

TEST(BadBSplineCurve, OperationsAreRefused) {
    const BSplineCurve curve(line, Points({0, 0, 1, 1}, 2));
    const auto insert = [&](double knot) {
        return code_of([&] { insert_knots(curve, std::vector<double>{knot}); });
    };
    EXPECT_EQ(insert(0), "curve.outside");
    EXPECT_EQ(insert(1), "curve.outside");
    EXPECT_EQ(insert(nan), "curve.outside");
    EXPECT_EQ(code_of([&] {
                  insert_knots(curve, std::vector<double>{0.5, 0.5});
              }),
              "bspline.knots");
    EXPECT_EQ(code_of([&] { elevate_degree(curve, 0); }), "bspline.degree");
    EXPECT_EQ(code_of([&] { elevate_degree(curve, 25); }), "bspline.degree");
    const BSplineCurve quartic = elevate_degree(curve, 3);
    EXPECT_EQ(code_of([&] { to_piecewise_cubic(quartic); }), "bspline.degree");
    const BSplineCurve rational(line, Points({0, 0, 1, 1}, 2), {1, 2});
    EXPECT_EQ(code_of([&] { to_piecewise_cubic(rational); }), "bspline.weights");
    const PiecewiseCubic pieces = to_piecewise_cubic(curve);
    EXPECT_EQ(code_of([&] { to_bspline(pieces, std::vector<int>{1}); }), "bspline.continuity");
    const PiecewiseCubic two = to_piecewise_cubic(insert_knots(curve, std::vector<double>{0.5}));
    EXPECT_EQ(code_of([&] { to_bspline(two, std::vector<int>{3}); }), "bspline.continuity");
    EXPECT_EQ(code_of([&] { to_bspline(two, std::vector<int>{-1}); }), "bspline.continuity");
}

}  // namespace bspline_bad_test
}  // namespace batten
