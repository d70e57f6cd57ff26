#include "batten/base/error.hpp"
#include "batten/make/fit_chunks.hpp"
#include "batten/make/fit_curve.hpp"
#include "errors.hpp"
#include "fit_samples.hpp"

/// Nonsense in, the right error out.
namespace batten {
namespace fit_bad_test {

using testing::FitTable;
using testing::inf;
using testing::nan;

FitTable good() { return testing::noisy_curve(50, 1, 1); }

std::string refusal(const FitTable& table, const FitOptions& options = {}) {
    return testing::code_and_place_of([&] { fit(table.view(), options); });
}

FitOptions given(std::vector<double> knots) {
    FitOptions options;
    options.knots = KnotPlacement::given;
    options.knots_values = std::move(knots);
    return options;
}

TEST(FitRefuses, FewerSamplesThanCoefficients) {
    FitTable table = good();
    for (auto* column : {&table.x, &table.y, &table.sigma}) column->resize(6);
    EXPECT_EQ(refusal(table, given({3, 4, 5})), "fit.too-few samples");
    for (auto* column : {&table.x, &table.y, &table.sigma}) column->resize(3);
    EXPECT_EQ(refusal(table), "fit.too-few samples");
    EXPECT_EQ(refusal({}), "fit.too-few samples");
}

TEST(FitRefuses, SamplesWithoutWeightOnly) {
    FitTable table = good();
    table.sigma.assign(table.sigma.size(), inf);
    EXPECT_EQ(refusal(table), "fit.too-few samples");
}

TEST(FitRefuses, EqualAbscissae) {
    FitTable table = good();
    table.x.assign(table.x.size(), 3);
    EXPECT_EQ(refusal(table), "fit.x-equal x");
}

TEST(FitRefuses, ErrorsThatAreNotAboveZero) {
    FitOptions endless;
    endless.sigma = inf;
    EXPECT_EQ(refusal({good().x, good().y, {}}, endless), "fit.sigma sigma");
    for (const double sigma : {0.0, -1.0, nan, -inf}) {
        FitTable table = good();
        table.sigma[7] = sigma;
        EXPECT_EQ(refusal(table), "fit.sigma row 7, column sigma") << sigma;
        FitOptions options;
        options.sigma = sigma;
        table.sigma.clear();
        EXPECT_EQ(refusal(table, options), "fit.sigma sigma") << sigma;
    }
}

TEST(FitRefuses, ModelsThatGiveNoError) {
    FitTable table = good();
    table.sigma.clear();
    FitOptions options;
    options.sigma_model = {0, -1};
    EXPECT_EQ(refusal(table, options), "fit.sigma-model row 0");
    options.sigma_model = {1};
    EXPECT_EQ(refusal(table, options), "fit.sigma-model sigma_model");
}

TEST(FitRefuses, NumbersThatAreNotFinite) {
    for (const double bad : {nan, inf, -inf}) {
        FitTable table = good();
        table.x[7] = bad;
        EXPECT_EQ(refusal(table), "points.not-finite row 7, column x");
        table = good();
        table.y[49] = bad;
        EXPECT_EQ(refusal(table), "points.not-finite row 49, column y");
    }
}

TEST(FitRefuses, NumbersThatAreNotFiniteWhereverTheyAreReduced) {
    for (const double bad : {nan, inf, -inf}) {
        for (const KnotPlacement knots :
             {KnotPlacement::automatic, KnotPlacement::equal, KnotPlacement::free,
              KnotPlacement::pruned}) {
            FitTable table = testing::noisy_curve(5000, 1, 1);
            table.y[3777] = bad;
            FitOptions options;
            options.knots = knots;
            if (knots == KnotPlacement::equal) options.intervals = 20;
            EXPECT_EQ(refusal(table, options), "points.not-finite row 3777, column y") << bad;
            table.y[3777] = 0;
            table.x[3777] = bad;
            EXPECT_EQ(refusal(table, options), "points.not-finite row 3777, column x") << bad;
        }
    }
}

TEST(FitRefuses, ColumnsOfDifferentLengths) {
    FitTable table = good();
    table.y.pop_back();
    EXPECT_EQ(refusal(table), "fit.lengths samples");
    table = good();
    table.sigma.pop_back();
    EXPECT_EQ(refusal(table), "fit.lengths samples");
}

TEST(FitRefuses, DistributionsThatAreNone) {
    FitOptions options;
    options.stop = StopRule::distribution;
    options.distribution = {0.68, 0.5};
    EXPECT_EQ(refusal(good(), options), "fit.distribution probability 2");
    options.distribution = {0.68, 1.2};
    EXPECT_EQ(refusal(good(), options), "fit.distribution probability 2");
    options.distribution = {nan};
    EXPECT_EQ(refusal(good(), options), "fit.distribution probability 1");
    options.distribution.assign(11, 1);
    EXPECT_EQ(refusal(good(), options), "fit.distribution distribution");
    options.stop = StopRule::bic;
    options.distribution = {0.68};
    EXPECT_EQ(refusal(good(), options), "fit.options distribution");
    FitOptions target = given({50});
    target.delta2 = 3;
    EXPECT_EQ(refusal(good(), target), "fit.options delta2");
}

TEST(FitRefuses, KnotsOutsideTheDataOrFalling) {
    EXPECT_EQ(refusal(good(), given({-1})), "fit.knots knot 1");
    EXPECT_EQ(refusal(good(), given({50, 101})), "fit.knots knot 2");
    EXPECT_EQ(refusal(good(), given({50, 40})), "fit.knots knot 2");
    EXPECT_EQ(refusal(good(), given({50, nan})), "fit.knots knot 2");
    EXPECT_EQ(refusal(good(), given({50, 50, 50, 50, 50})), "fit.knots knot 5");
    FitOptions closed = given({40, 40});
    closed.closed = true;
    EXPECT_EQ(refusal(good(), closed), "fit.knots knot 2");
}

TEST(FitRefuses, NoIntervals) {
    FitOptions options;
    options.intervals = 0;
    EXPECT_EQ(refusal(good(), options), "fit.intervals intervals");
}

TEST(FitRefuses, OptionsThatContradictEachOther) {
    FitOptions options;
    options.stop = StopRule::none;
    EXPECT_EQ(refusal(good(), options), "fit.options stop");
    options = {};
    options.knots_values = {50};
    options.knots = KnotPlacement::equal;
    EXPECT_EQ(refusal(good(), options), "fit.options knots_values");
    options = {};
    options.free_from = 10;
    EXPECT_EQ(refusal(good(), options), "fit.options free_from");
    options = given({50});
    options.intervals = 3;
    EXPECT_EQ(refusal(good(), options), "fit.options intervals");
    options = {};
    options.knots = KnotPlacement::free;
    options.degree = 0;
    EXPECT_EQ(refusal(good(), options), "fit.options degree");
    options = {};
    options.degree = 10;
    EXPECT_EQ(refusal(good(), options), "option.range degree");
    options = {};
    options.delta2 = -1;
    EXPECT_EQ(refusal(good(), options), "option.range delta2, free_from");
}

TEST(FitRefuses, LimitsAndTolerancesThatContradictTheRest) {
    FitOptions options;
    options.start_value = 1;
    options.closed = true;
    EXPECT_EQ(refusal(good(), options), "fit.options closed");
    options = {};
    options.convex = Direction::up;
    options.degree = 0;
    EXPECT_EQ(refusal(good(), options), "fit.options degree");
    options = {};
    options.tolerance = absolute(0);
    EXPECT_EQ(refusal(good(), options), "option.range tolerance");
    options.tolerance = absolute(1);
    options.intervals = 4;
    EXPECT_EQ(refusal(good(), options), "fit.options tolerance");
    options = {};
    options.knots = KnotPlacement::pruned;
    options.intervals = 4;
    EXPECT_EQ(refusal(good(), options), "fit.options knots");
}

TEST(FitSays, WhereLimitsCannotBeKept) {
    FitOptions options;
    options.degree = 1;
    options.intervals = 1;
    options.start_value = 0;
    options.start_slope = 1;
    options.end_value = 0;
    EXPECT_EQ(fit(good().view(), options).report.status, Status::not_met);
}

TEST(FitCurveRefuses, WhatMakesNoSenseForACurve) {
    const auto code = [](const Points& points, const FitOptions& options,
                          const std::vector<double>& sigma = {}) {
        return testing::code_and_place_of([&] { fit_curve(points, sigma, options); });
    };
    const Points points({0, 0, 1, 1, 2, 0, 3, 1, 4, 0, 5, 1}, 2);
    EXPECT_EQ(code(Points(5, 1), {}), "points.dimension points");
    EXPECT_EQ(code(Points(0, 2), {}), "fit.too-few samples");
    EXPECT_EQ(code(points, {}, {1, 1}), "fit.lengths sigma");
    EXPECT_EQ(code(points, {}, {1, 1, 0, 1, 1, 1}), "fit.sigma row 2, column sigma");
    EXPECT_EQ(code(Points({1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, 2), {}), "points.all-equal points");
    FitOptions options;
    options.monotone = Direction::up;
    EXPECT_EQ(code(points, options), "fit.options monotone, convex");
    options = {};
    options.end_slope = 1;
    EXPECT_EQ(code(points, options),
              "fit.options start_value, start_slope, end_value, end_slope");
    options = {};
    options.degree = 0;
    EXPECT_EQ(code(points, options), "fit.options degree");
    EXPECT_EQ(code(Points({0, 0, 1, 1}, 2), {}), "fit.too-few samples");
}

TEST(FitCurveRefuses, EndsThatThereAreNot) {
    const Points points({0, 0, 1, 1, 2, 0, 3, 1, 4, 0, 5, 1}, 2);
    const auto code = [&](const FitOptions& options) {
        return testing::code_and_place_of([&] { fit_curve(points, {}, options); });
    };
    FitOptions options;
    options.fix_ends = options.closed = true;
    EXPECT_EQ(code(options), "fit.options closed");
    for (const std::vector<double>& bad :
         {std::vector<double>{0, 0}, {1, 0, 0}, {1}, {nan, 1}, {inf, 1}}) {
        options = {};
        options.end_tangent = bad;
        EXPECT_EQ(code(options), "fit.tangent end_tangent");
    }
    options = {};
    options.start_tangent = {1, 0};
    EXPECT_EQ(testing::code_and_place_of([&] { fit(good().view(), options); }),
              "fit.options fix_ends, start_tangent, end_tangent");
}

TEST(FitRefuses, ResultsBeyondADouble) {
    FitTable table = good();
    for (double& y : table.y) y *= 1e306;
    for (double& s : table.sigma) s = 1;
    EXPECT_EQ(refusal(table, given({1e-3})).substr(0, 15), "number.overflow");
}

TEST(FitRefuses, UnitsWhoseSquaresOrDerivativesAreBeyondADouble) {
    const auto with = [](double x_unit, double y_unit, double sigma) {
        FitTable table = good();
        for (double& x : table.x) x *= x_unit;
        for (double& y : table.y) y *= y_unit;
        table.sigma.clear();
        FitOptions options;
        if (sigma > 0) options.sigma = sigma;
        return refusal(table, options);
    };
    EXPECT_EQ(with(1, 1, 1e300), "number.overflow sigma");
    EXPECT_EQ(with(1, 1, 1e-300), "number.overflow sigma");
    EXPECT_EQ(with(1, 1e300, 0), "number.overflow column y");
    EXPECT_EQ(with(1, 1e306, 0), "number.overflow column y");
    EXPECT_EQ(with(1e-200, 1, 1), "number.overflow column x");
    EXPECT_EQ(with(1e-322, 1, 1), "number.overflow column x");
    FitTable wide{{-1.7e308, -1e308, 0, 1e308, 1.7e308}, {0, 1, 0, 1, 0}, {}};
    EXPECT_EQ(refusal(wide), "number.overflow column x");
    EXPECT_EQ(with(1e-50, 1e100, 1e100), "none");
}

TEST(FitRefuses, ANumberOfIntervalsAndATargetForDelta2) {
    FitOptions options;
    options.intervals = 5;
    options.delta2 = 3;
    EXPECT_EQ(refusal(good(), options), "fit.options intervals");
}

TEST(FitSays, HowManyIntervalsTheSamplesDetermine) {
    FitOptions options;
    options.intervals = 1000;
    const FitReport report = fit(good().view(), options).report;
    EXPECT_EQ(report.status, Status::not_met);
    ASSERT_EQ(report.notes.size(), 1u);
    EXPECT_EQ(report.notes[0], "intervals: the samples determine no more than " +
                                   std::to_string(report.intervals));
}

TEST(FitChunkRefuses, WhatDoesNotBelongToIt) {
    const auto code = [](auto action) { return testing::code_of(action); };
    FitChunk chunk({0, 100}, {50}, 3);
    EXPECT_EQ(code([&] { chunk.merge(FitChunk({0, 100}, {51}, 3)); }), "fit.chunks-differ");
    EXPECT_EQ(code([&] { chunk.merge(FitChunk({0, 100}, {50}, 2)); }), "fit.chunks-differ");
    EXPECT_EQ(code([&] { FitChunk({0, 10}, {50}, 3); }), "fit.knots");
    EXPECT_EQ(code([&] { FitChunk({0, 0}, {}, 3); }), "fit.knots");
    EXPECT_EQ(code([&] { FitChunk({0, 10}, {}, 11); }), "option.range");
    EXPECT_EQ(code([&] { chunk.solve(); }), "fit.too-few");
    FitTable table = good();
    table.x[3] = 101;
    EXPECT_EQ(code([&] { chunk.add(table.view()); }), "fit.outside");
}

/// Many samples over fixed knots are looked at while they are summed.
TEST(FitRefuses, TheSameInManySamples) {
    const FitTable many = testing::noisy_curve(6000, 1, 1);
    const FitOptions options = given({20, 40, 60, 80});
    for (const double bad : {nan, -nan, inf, -inf}) {
        FitTable table = many;
        table.x[4321] = bad;
        EXPECT_EQ(refusal(table, options), "points.not-finite row 4321, column x") << bad;
        table = many;
        table.y[5999] = bad;
        EXPECT_EQ(refusal(table, options), "points.not-finite row 5999, column y") << bad;
    }
    for (const double bad : {nan, -nan, 0.0, -0.0, -1.0}) {
        FitTable table = many;
        table.sigma[77] = bad;
        EXPECT_EQ(refusal(table, options), "fit.sigma row 77, column sigma") << bad;
    }
    FitTable table = many;
    for (double& y : table.y) y *= 1e200;
    EXPECT_EQ(refusal(table, options), "number.overflow sigma");
}

}  // namespace fit_bad_test
}  // namespace batten
