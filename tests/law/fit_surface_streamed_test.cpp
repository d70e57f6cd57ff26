#include "errors.hpp"
#include "surface_streams.hpp"

/// Knot lines searched on grids that come in blocks of rows are those of the grid in memory.
namespace batten {
namespace fit_surface_streamed_test {

using namespace testing;

void expect_same(const SurfaceFit& made, const SurfaceFit& want) {
    EXPECT_EQ(made.report.knots_x, want.report.knots_x);
    EXPECT_EQ(made.report.knots_y, want.report.knots_y);
    EXPECT_EQ(made.report.psi, want.report.psi);
    EXPECT_EQ(made.report.status, want.report.status);
    EXPECT_EQ(made.report.sigma_source, want.report.sigma_source);
    EXPECT_EQ(made.report.chi2_p.has_value(), want.report.chi2_p.has_value());
    EXPECT_NEAR(made.report.delta2 / want.report.delta2, 1, 1e-10);
    ASSERT_EQ(made.report.path.size(), want.report.path.size());
    for (std::size_t k = 0; k < want.report.path.size(); ++k) {
        EXPECT_EQ(made.report.path[k].intervals, want.report.path[k].intervals);
        EXPECT_NEAR(made.report.path[k].delta2 / want.report.path[k].delta2, 1, 1e-9);
    }
    const std::span<const double> a = made.surface.coefficients(), b = want.surface.coefficients();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-11);
}

TEST(StreamedSearch, FindsTheLinesOfTheGridInMemory) {
    for (const auto& [m, n] : {std::pair{512, 512}, std::pair{1024, 700}}) {
        const SurfaceTable table = surface_of(land, m, n, 0.02);
        for (const bool knows_sigma : {true, false}) {
            FitSurfaceOptions options;
            if (knows_sigma) options.sigma = 0.02;
            const SurfaceFit whole = fit_surface(table.view(), options);
            EXPECT_GT(whole.report.intervals[0], 8);
            EXPECT_GT(whole.report.intervals[1], 8);
            for (const std::size_t rows : {1, 7, 1024}) {
                SCOPED_TRACE(std::to_string(m) + " rows, " + std::to_string(rows) + " at once");
                expect_same(fit_surface(stream_of(table, rows), options), whole);
            }
        }
    }
}

TEST(StreamedSearch, StopsByTheRulesOfTheGridInMemory) {
    const SurfaceTable table = surface_of(land, 400, 300, 0.02);
    const auto expect_same_fit = [&](FitSurfaceOptions options) {
        expect_same(fit_surface(stream_of(table), options), fit_surface(table.view(), options));
    };
    FitSurfaceOptions options;
    for (const int degree : {1, 2, 5}) {
        options.degree = degree;
        expect_same_fit(options);
    }
    options = {};
    options.intervals = {9, 14};
    expect_same_fit(options);
    options = {};
    options.stop = StopRule::chi2;
    options.sigma = 0.02;
    expect_same_fit(options);
    options.stop = StopRule::aic;
    options.sigma.reset();
    expect_same_fit(options);
    options = {};
    options.delta2 = 1.1 * 400 * 300;
    expect_same_fit(options);
    options.delta2 = 100;
    options.sigma = 10;
    expect_same_fit(options);
}

TEST(StreamedSearch, WeighsRowsAndColumns) {
    const SurfaceTable table = surface_of(land, 400, 300, 0.02);
    const UnevenErrors errors(table);
    expect_same(fit_surface(errors.of(stream_of(table, 50)), {}),
                fit_surface(errors.of(table.view()), {}));
}

/// Errors a ten-millionth of the heights: square sums alone would tell nothing of delta2.
TEST(StreamedSearch, LosesNothingWhereTheHeightsAreNearlyExact) {
    const SurfaceTable table = surface_of(land, 256, 256, 1e-7);
    FitSurfaceOptions options;
    options.intervals = {48, 48};
    options.sigma = 1e-7;
    const SurfaceFit whole = fit_surface(table.view(), options);
    const SurfaceFit made = fit_surface(stream_of(table), options);
    EXPECT_EQ(made.report.knots_x, whole.report.knots_x);
    EXPECT_EQ(made.report.knots_y, whole.report.knots_y);
    EXPECT_NEAR(made.report.path.back().delta2 / made.report.delta2, 1, 1e-6);
    EXPECT_NEAR(made.report.delta2 / whole.report.delta2, 1, 1e-7);
}

/// A step a few rows wide: its strips are halved beyond what lines allow everywhere.
TEST(StreamedSearch, HalvesOnWhereTheGridIsFinest) {
    const auto step = [](double x, double y) { return std::tanh(400 * (x - 0.4137)) * (1 + y); };
    const SurfaceTable table = surface_of(step, 600, 100, 0.001);
    FitSurfaceOptions options;
    options.sigma = 0.001;
    const SurfaceFit whole = fit_surface(table.view(), options);
    EXPECT_LE(narrowest_strip(whole.report), 1.0 / 512);
    expect_same(fit_surface(stream_of(table), options), whole);
}

TEST(StreamedSearch, HoldsGridsThatAreSmall) {
    const SurfaceTable table = surface_of(land, 60, 50, 0.02);
    FitSurfaceOptions options;
    options.knots = SurfaceKnots::free;
    options.intervals = {3, 3};
    const SurfaceFit whole = fit_surface(table.view(), options);
    const SurfaceFit made = fit_surface(stream_of(table), options);
    EXPECT_EQ(made.report.knots_x, whole.report.knots_x);
    EXPECT_EQ(made.report.delta2, whole.report.delta2);
}

}  // namespace fit_surface_streamed_test
}  // namespace batten
