#include "batten/io/curve_file.hpp"
#include "batten/io/json.hpp"
#include "batten/make/fit.hpp"
#include "errors.hpp"
#include "fit_samples.hpp"

#include <gtest/gtest.h>

/// How sure a fit is goes through its file unchanged.
namespace batten {
namespace fit_covariance_file_law_test {

Fit periodic_fit(FitOptions options) {
    testing::FitTable table;
    testing::Noise noise(6);
    for (int i = 0; i < 100; ++i) {
        table.x.push_back(i / 99.0);
        table.y.push_back(std::sin(6.283 * i / 99.0) + 0.05 * noise.normal());
    }
    options.closed = true;
    return fit(table.view(), options);
}

std::vector<Fit> fits() {
    const testing::FitTable table = testing::noisy_curve(120, 1.5, 3);
    FitOptions given, limited, estimated, moved, few;
    given.knots_values = {20, 40, 50, 60, 60, 80};
    limited.start_value = 18;
    limited.end_slope = 0;
    estimated.degree = 1;
    moved.knots = KnotPlacement::pruned;
    few.knots = KnotPlacement::equal;
    few.intervals = 2;
    std::vector<Fit> result;
    for (const FitOptions& o : {FitOptions{}, given, limited, moved}) {
        result.push_back(fit(table.view(), o));
    }
    result.push_back(fit(table.without_sigma(), estimated));
    result.push_back(periodic_fit({}));
    result.push_back(periodic_fit(few));
    return result;
}

Curve through_a_file(const Curve& curve) {
    return curve_of(parse_json(dump_json(curve_value(curve)), "copy"), "copy");
}

TEST(FitCovariance, IsReadAsItWasWritten) {
    for (const Fit& made : fits()) {
        const Curve curve = with_covariance(graph(made.spline), made.covariance);
        const Curve copy = through_a_file(curve);
        const FitCovariance* read = covariance_of(copy);
        ASSERT_NE(read, nullptr);
        const Interval domain = made.spline.domain();
        for (int i = 0; i <= 20; ++i) {
            const double x = domain.lo + domain.length() * (i / 20.0);
            for (int d = 0; d < 2; ++d) {
                EXPECT_EQ(read->deviation(x, d), made.covariance.deviation(x, d));
            }
        }
        EXPECT_EQ(read->factor_95(), made.covariance.factor_95());
        EXPECT_EQ(read->integral(domain).deviation, made.covariance.integral(domain).deviation);
        EXPECT_EQ(read->covariance(0, 1), made.covariance.covariance(0, 1));
        EXPECT_EQ(dump_json(curve_value(copy)), dump_json(curve_value(curve)));
    }
}

TEST(FitCovariance, WidensWithThePercentage) {
    const Fit known = fits()[0], estimated = fits()[4];
    EXPECT_EQ(known.covariance.factor_95(), 1.959963984540054);
    EXPECT_NEAR(known.covariance.factor(99), 2.5758293035489004, 1e-12);
    EXPECT_NEAR(known.covariance.factor(68.26894921370859), 1, 1e-12);
    EXPECT_GT(estimated.covariance.factor(99), 2.5758);
}

TEST(FitCovariance, DoesNotGoWithACurveMadeOfTheFit) {
    const Fit made = fits()[0];
    const Curve curve = with_covariance(graph(made.spline), made.covariance);
    EXPECT_NE(covariance_of(curve), nullptr);
    EXPECT_EQ(covariance_of(trimmed(curve, {10, 20})), nullptr);
    EXPECT_EQ(covariance_of(graph(made.spline)), nullptr);
}

TEST(FitCovariance, OfAFileThatIsWrongIsRefused) {
    const Fit made = fits()[0];
    const std::string good =
        dump_json(curve_value(with_covariance(graph(made.spline), made.covariance)));
    const auto refusal = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const std::size_t at = text.find(from, text.find("\"fit\""));
        if (at == std::string::npos) return "no " + from;
        text.replace(at, from.size(), to);
        return testing::code_and_place_of([&] { curve_of(parse_json(text, "f"), "f"); });
    };
    EXPECT_EQ(refusal("\"scale\": 1", "\"scale\": -1"), "curve.entry f, entry fit, entry scale");
    EXPECT_EQ(refusal("\"degree\": 3", "\"degree\": 2").substr(0, 12), "spline.knots");
    EXPECT_EQ(refusal("\"triangle\": [", "\"triangle\": [[1, 2, 3, 4], "),
              "curve.entry f, entry fit, entry spline, entry triangle");
    EXPECT_EQ(refusal("\"border\": []", "\"border\": [[1]]"),
              "curve.entry f, entry fit, entry spline, entry triangle");
    EXPECT_EQ(refusal("\"known\": []", "\"known\": [[1]]"),
              "curve.entry f, entry fit, entry spline, entry known[0]");
    EXPECT_EQ(refusal("\"alternatives\"", "\"others\""),
              "curve.entry f, entry fit, entry alternatives");
}

}  // namespace fit_covariance_file_law_test
}  // namespace batten
