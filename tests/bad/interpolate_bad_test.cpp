#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/make/interpolate.hpp"
#include "batten/make/natural_spline.hpp"
#include "errors.hpp"

namespace batten {
namespace interpolate_bad_test {

using testing::complaint_of;
using testing::inf;
using testing::nan;

const Points zigzag({0, 0, 1, 1, 2, 0, 3, 1}, 2);

/// `code: place: value: rule` of the error, or "none"; the same with and without a report.
std::string message_of(PointsView points, const InterpolateOptions& options) {
    const std::string message = complaint_of([&] { curve_through(points, options); });
    EXPECT_EQ(message, complaint_of([&] { interpolate(points, options); }));
    return message;
}

std::string code_of(PointsView points, const InterpolateOptions& options) {
    const std::string message = message_of(points, options);
    return message.substr(0, message.find(':'));
}

InterpolateOptions by(Method method) {
    InterpolateOptions options;
    options.method = method;
    return options;
}

InterpolateOptions closed(Method method) {
    InterpolateOptions options = by(method);
    options.closed = true;
    return options;
}

std::vector<Method> all_methods() {
    std::vector<Method> all;
    for (const auto& word : names_of(Method{})) all.push_back(word.value);
    return all;
}

TEST(BadPoints, AreRefusedByEveryMethod) {
    for (const Method method : all_methods()) {
        const auto code = [&](std::vector<double> coordinates) {
            return code_of(Points(std::move(coordinates), 2), by(method));
        };
        EXPECT_EQ(code({}), "points.too-few");
        EXPECT_EQ(code({1, 2}), "points.too-few");
        EXPECT_EQ(code({1, 2, 1, 2}), "points.all-equal");
        EXPECT_EQ(code({1, 2, 1, 2, 1, 2}), "points.all-equal");
        EXPECT_EQ(code({0, 0, 1, 2, 1, 2, 3, 3}), "points.repeated");
        EXPECT_EQ(code({0, 0, nan, 2, 2, 2, 3, 3}), "points.not-finite");
        EXPECT_EQ(code({0, 0, 1, 2, 2, 2, 3, -inf}), "points.not-finite");
        EXPECT_EQ(code({0, 0, 1, 1.7e308, 2, -1.7e308, 3, 0}), "number.overflow");
        EXPECT_EQ(code_of(Points({0, 1, 2}, 1), by(method)) == "points.dimension",
                  method != Method::spline && method != Method::natural_chord &&
                      method != Method::natural_uniform && method != Method::lagrange_2 &&
                      method != Method::lagrange_3);
    }
    EXPECT_EQ(message_of(Points({0, 0, 1, nan}, 2), {}),
              "points.not-finite: point 1, coordinate 1: nan: coordinates must be finite");
}

TEST(BadPoints, OfTooManyDimensionsAreRefused) {
    const Points four({0, 0, 0, 0, 1, 2, 3, 4, 5, 3, 2, 1}, 4);
    const Points three({0, 0, 0, 1, 2, 3, 5, 3, 2}, 3);
    EXPECT_EQ(code_of(four, by(Method::pseudo_spline)), "points.dimension");
    EXPECT_EQ(code_of(three, by(Method::pseudo_spline_global)), "points.dimension");
    EXPECT_EQ(code_of(three, by(Method::pchip)), "points.dimension");
    EXPECT_EQ(code_of(four, by(Method::hermite_arc)), "none");
}

TEST(BadPoints, OfAClosedCurveAreRefused) {
    for (const Method method : all_methods()) {
        if (method == Method::pchip || method == Method::makima) continue;
        EXPECT_EQ(code_of(Points({0, 0, 1, 1}, 2), closed(method)), "points.too-few");
        EXPECT_EQ(code_of(Points({0, 0, 1, 1, 0, 0}, 2), closed(method)), "points.too-few");
        EXPECT_EQ(code_of(Points({0, 0, 1, 1, 2, 0, 0, 0, 0, 0}, 2), closed(method)),
                  "points.repeated");
    }
}

TEST(BadPoints, ThatLeaveTheRangeOfADoubleAreRefused) {
    const Points far({0, 0, 1e200, 1e200, 2e200, 0}, 2), near({0, 0, 1e-200, 1e-200, 2e-200, 0}, 2);
    for (const Points& points : {far, near}) {
        EXPECT_EQ(code_of(points, by(Method::natural_chord)), "number.overflow");
        EXPECT_EQ(curve_through(points, by(Method::natural_uniform)).pieces(), 2u);
        EXPECT_EQ(curve_through(points, by(Method::pseudo_spline)).pieces(), 2u);
    }
    EXPECT_EQ(code_of(Points({0, 0, 1e300, 0, 1e300, 1}, 2), by(Method::natural_chord)),
              "number.overflow");
    EXPECT_EQ(code_of(Points({0, 0, 1e30, 0, 1e30, 1}, 2), by(Method::natural_chord)),
              "interpolate.parameters");
}

TEST(BadParameters, AreRefused) {
    InterpolateOptions options = by(Method::spline);
    const auto code = [&](std::vector<double> values) {
        options.parameter_values = std::move(values);
        return code_of(zigzag, options);
    };
    EXPECT_EQ(code({0, 1, 2, 3}), "none");
    EXPECT_EQ(code({0, 1, 2}), "interpolate.parameters");
    EXPECT_EQ(code({0, 1, 2, 3, 4}), "interpolate.parameters");
    EXPECT_EQ(code({0, 1, 1, 3}), "interpolate.parameters");
    EXPECT_EQ(code({0, 1, nan, 3}), "interpolate.parameters");
    EXPECT_EQ(code({0, 1, 2, inf}), "interpolate.parameters");
    EXPECT_EQ(code({0, 5e-324, 1e-323, 3}), "number.overflow");
    options.closed = true;
    EXPECT_EQ(code({0, 1, 2, 3}), "interpolate.parameters");
    EXPECT_EQ(code({0, 1, 2, 3, 4}), "none");
    options.method = Method::natural_chord;
    EXPECT_EQ(code_of(zigzag, options), "interpolate.parameters-not-taken");
    options.method = Method::pseudo_spline;
    EXPECT_EQ(code_of(zigzag, options), "interpolate.parameters-not-taken");
}

TEST(BadAbscissae, AreRefused) {
    for (const Method method : {Method::pchip, Method::makima}) {
        EXPECT_EQ(code_of(Points({0, 0, 1, 1, 1, 2}, 2), by(method)),
                  "interpolate.x-not-increasing");
        EXPECT_EQ(message_of(Points({0, 0, 1, 1, 0.5, 2}, 2), by(method)),
                  "interpolate.x-not-increasing: point 2, coordinate 0: 0.5: x must be larger than "
                  "that of the point before");
        EXPECT_EQ(code_of(zigzag, closed(method)), "interpolate.closed-not-taken");
        EXPECT_EQ(code_of(Points({0, 0, 1e-320, 1e300}, 2), by(method)), "number.overflow");
    }
}

TEST(BadCorners, AreRefused) {
    InterpolateOptions options = by(Method::hermite_arc);
    const auto code = [&](int corner) {
        options.corner = {corner};
        return code_of(zigzag, options);
    };
    EXPECT_EQ(code(-1), "interpolate.corner-outside");
    EXPECT_EQ(code(4), "interpolate.corner-outside");
    EXPECT_EQ(code(3), "none");
    for (const Method method : {Method::natural_uniform, Method::spline, Method::pchip}) {
        options.method = method;
        EXPECT_EQ(code(1), "interpolate.corner-not-taken");
    }
}

TEST(BadTangents, AreRefused) {
    const auto code = [&](InterpolateOptions options, std::vector<FixedTangent> tangents) {
        options.tangent = std::move(tangents);
        return code_of(zigzag, options);
    };
    InterpolateOptions options = by(Method::pseudo_spline);
    EXPECT_EQ(code(options, {{-1, {0}}}), "interpolate.tangent-outside");
    EXPECT_EQ(code(options, {{4, {0}}}), "interpolate.tangent-outside");
    EXPECT_EQ(code(options, {{1, {nan}}}), "option.range");
    EXPECT_EQ(code(options, {{1, {0}}, {1, {0}}}), "interpolate.tangent-repeated");
    options.corner = {0, 1};
    EXPECT_EQ(code(options, {{0, {0}}}), "none");
    EXPECT_EQ(code(options, {{1, {0}}}), "interpolate.tangent-at-corner");
    for (const Method method :
         {Method::natural_uniform, Method::natural_chord, Method::spline, Method::makima}) {
        EXPECT_EQ(code(by(method), {{0, {0}}}), "interpolate.tangent-not-taken");
    }
    options = by(Method::spline);
    options.ends = Ends::clamped;
    EXPECT_EQ(code(options, {{0, {0}}, {3, {1}}}), "none");
    EXPECT_EQ(code(options, {{1, {0}}}), "interpolate.tangent-not-taken");
    options.closed = true;
    EXPECT_EQ(code(options, {{0, {0}}}), "interpolate.tangent-not-taken");
    options = by(Method::hermite_arc);
    options.tangent = {{0, {0}}};
    EXPECT_EQ(code_of(Points({0, 0, 0, 1, 1, 1, 2, 0, 1}, 3), options),
              "interpolate.tangent-not-taken");
}

TEST(BadParts, AreRefused) {
    const auto code = [&](int from, int to) {
        InterpolateOptions options = by(Method::hermite_arc);
        options.part = {from, to};
        return code_of(zigzag, options);
    };
    EXPECT_EQ(code(0, 3), "none");
    EXPECT_EQ(code(-1, 2), "interpolate.part-outside");
    EXPECT_EQ(code(0, 4), "interpolate.part-outside");
    EXPECT_EQ(code(2, 1), "interpolate.part-empty");
    EXPECT_EQ(code(2, 2), "interpolate.part-empty");
}

TEST(BadWeightExponents, AreRefused) {
    InterpolateOptions options;
    for (const double exponent : {nan, inf, 8.5, -9.0}) {
        options.weight_exponent = exponent;
        EXPECT_EQ(code_of(zigzag, options), "option.range");
    }
}

std::string message_in_bulk(PointsView points, std::size_t breaks, std::size_t numbers) {
    std::vector<double> own_breaks(breaks), block(numbers);
    return complaint_of([&] { natural_spline(points, own_breaks, block); });
}

TEST(NaturalSpline, InBulkRefusesWhatNaturalChordRefuses) {
    const std::vector<std::vector<double>> all{
        {},
        {0, 0},
        {0, 0, 1, 1, 1, 1, 2, 0},
        {3, 4, 3, 4, 3, 4},
        {0, 0, nan, 1, 2, 2},
        {0, 0, 1, inf, 2, 2},
        {0, 0, 1e-200, 0, 1, 1},
        {0, 0, 1e200, 0, 1, 1},
        {-1e308, 0, 1e308, 0, 1, 1},
        {0, 0, 1, 0, 1, 1e-17, 2, 0},
    };
    for (const std::vector<double>& coordinates : all) {
        const Points points(coordinates, 2);
        const std::string message = message_of(points, by(Method::natural_chord));
        EXPECT_NE(message, "none");
        EXPECT_EQ(message_in_bulk(points, points.size(), 8 * points.size()), message);
    }
}

TEST(NaturalSpline, InBulkAsksForThePlaneAndForEnoughMemory) {
    const auto code = [](PointsView points, std::size_t breaks, std::size_t numbers) {
        const std::string message = message_in_bulk(points, breaks, numbers);
        return message.substr(0, message.find(':'));
    };
    EXPECT_EQ(code(zigzag, 4, 32), "none");
    EXPECT_EQ(code(zigzag, 3, 32), "curve.coefficients");
    EXPECT_EQ(code(zigzag, 4, 24), "curve.coefficients");
    EXPECT_EQ(code(Points({0, 0, 0, 1, 1, 1}, 3), 2, 16), "points.dimension");
}

}  // namespace interpolate_bad_test
}  // namespace batten
