#include <functional>
#include <limits>

#include "batten/base/error.hpp"
#include "batten/make/densify.hpp"
#include "batten/make/thin.hpp"
#include "errors.hpp"
#include "shared.hpp"

namespace batten {
namespace densify_bad_test {

using testing::code_of;
using testing::inf;
using testing::nan;

const Points good({0, 0, 1, 1, 2, 0, 3, 1, 4, 0}, 2);

std::string densify_code(const Points& points, const DensifyOptions& options) {
    return code_of([&] { densify(points, options); });
}

std::string good_code(const std::function<void(DensifyOptions&)>& change) {
    DensifyOptions options;
    change(options);
    return densify_code(good, options);
}

TEST(DensifyBad, PointsAreNamed) {
    EXPECT_EQ(densify_code(Points({0, 0, 1, 1, 2, 0}, 2), {}), "points.too-few");
    EXPECT_EQ(densify_code(Points(2), {}), "points.too-few");
    EXPECT_EQ(densify_code(Points({0, 0, 1, nan, 2, 0, 3, 1}, 2), {}), "points.not-finite");
    EXPECT_EQ(densify_code(Points({0, 0, 1, 1, 2, inf, 3, 1, 4, 4, 5, 5, 6, 7}, 2), {}),
              "points.not-finite");
    EXPECT_EQ(densify_code(Points({0, 0, 1, 1, 1, 1, 3, 1}, 2), {}), "points.repeated");
    EXPECT_EQ(densify_code(Points({1, 1, 1, 1, 1, 1, 1, 1}, 2), {}), "points.all-equal");
    EXPECT_EQ(densify_code(Points({-1.7e308, 0, 1.7e308, 1, -1.7e308, 2, 1.7e308, 3}, 2), {}),
              "number.overflow");
}

TEST(DensifyBad, NotFiniteAndRepeatedPointsAreFoundWhereverTheyStandAndWhateverIsAsked) {
    for (std::size_t row = 0; row < 9; ++row) {
        for (const int degree : {1, 2, 3, 5}) {
            for (const LagrangeParameter parameter :
                 {LagrangeParameter::index, LagrangeParameter::chord}) {
                Points points(9, 2);
                for (std::size_t i = 0; i < 9; ++i) {
                    points(i, 0) = static_cast<double>(i);
                    points(i, 1) = static_cast<double>(i % 2);
                }
                DensifyOptions options;
                options.degree = degree;
                options.parameter = parameter;
                Points bad = points;
                bad(row, 1) = row % 2 == 0 ? nan : inf;
                const std::string code = densify_code(bad, options);
                EXPECT_EQ(code, "points.not-finite") << row << degree;
                if (row == 0) continue;
                bad = points;
                std::copy_n(bad.view()[row - 1].begin(), 2, bad[row].begin());
                EXPECT_EQ(densify_code(bad, options), "points.repeated");
            }
        }
    }
}

TEST(DensifyBad, OptionsAreNamed) {
    EXPECT_EQ(good_code([](auto& o) { o.degree = 0; }), "option.range");
    EXPECT_EQ(good_code([](auto& o) { o.degree = 16; }), "option.range");
    EXPECT_EQ(good_code([](auto& o) { o.degree = 5; }), "points.too-few");
    EXPECT_EQ(good_code([](auto& o) { o.end_degree = 0; }), "option.range");
    EXPECT_EQ(good_code([](auto& o) { o.between = -1; }), "option.range");
    EXPECT_EQ(good_code([](auto& o) { o.tolerance = absolute(0); }), "option.range");
    EXPECT_EQ(good_code([](auto& o) { o.tolerance = absolute(-1); }), "option.range");
    EXPECT_EQ(good_code([](auto& o) { o.tolerance = absolute(nan); }), "option.range");
    EXPECT_EQ(good_code([](auto& o) { o.tolerance = relative(inf); }), "option.range");
    EXPECT_EQ(good_code([](auto& o) { o.tolerance = absolute(1e-30); }), "densify.too-many");
    EXPECT_EQ(good_code([](auto& o) { o.between = 100000000; }), "densify.too-many");
    EXPECT_EQ(good_code([](auto& o) {
                  o.between = 2;
                  o.tolerance = absolute(1);
              }),
              "densify.two-counts");
    EXPECT_EQ(good_code([](auto& o) {
                  o.blend = true;
                  o.degree = 1;
              }),
              "densify.blend-degree");
    EXPECT_EQ(good_code([](auto& o) { o.parameter_values = {0, 1, 2}; }),
              "lagrange.parameter-count");
    EXPECT_EQ(good_code([](auto& o) { o.parameter_values = {0, 1, 1, 2, 3}; }),
              "lagrange.parameters-not-increasing");
    EXPECT_EQ(good_code([](auto& o) { o.parameter_values = {0, 1, nan, 2, 3}; }),
              "lagrange.parameters-not-increasing");
    EXPECT_EQ(code_of([] { lagrange_weights(std::vector{0., 0.}, 0.5); }),
              "lagrange.parameters-not-increasing");
}

TEST(DensifyBad, ARingMayRepeatItsFirstPointAndIsToldSo) {
    DensifyOptions options;
    options.closed = true;
    options.degree = 2;
    const Points ring({0, 0, 1, 0, 1, 1, 0, 1, 0, 0}, 2);
    const Densified result = densify(ring, options);
    EXPECT_EQ(result.points.size(), 16u);
    EXPECT_FALSE(result.report.notes.empty());
    EXPECT_EQ(densify_code(Points({0, 0, 1, 0}, 2), options), "points.too-few");
}

TEST(ThinBad, InputIsNamed) {
    const auto code = [&](const Points& points, Tolerance tolerance) {
        ThinOptions options;
        options.tolerance = tolerance;
        return code_of([&] { thin(points, options); });
    };
    EXPECT_EQ(code(good, absolute(0)), "option.range");
    EXPECT_EQ(code(good, absolute(nan)), "option.range");
    EXPECT_EQ(code(Points({0, 0, 1, 1}, 2), absolute(1)), "points.too-few");
    EXPECT_EQ(code(Points({0, 0, 1, 1, 1, 1, 2, 0}, 2), absolute(1)), "points.repeated");
    EXPECT_EQ(code(Points({0, 0, 1, 1, nan, 1, 2, 0}, 2), absolute(1)), "points.not-finite");
}

}  // namespace densify_bad_test
}  // namespace batten
