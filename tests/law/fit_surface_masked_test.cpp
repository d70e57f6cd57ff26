#include "errors.hpp"
#include "surface_streams.hpp"

/// Large grids of which nodes are missing, in memory and in blocks of rows.
namespace batten {
namespace fit_surface_masked_test {

using namespace testing;

/// A fifth of the nodes is missing here and there, and all of a rectangle.
SurfaceTable holed(std::size_t m, std::size_t n, double sigma) {
    SurfaceTable table = surface_of(land, m, n, sigma);
    Noise noise(7);
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const bool is_in_hole = m / 2 < i && i < m / 2 + m / 8 && n / 3 < j && j < n / 2;
            if (is_in_hole || noise.normal() > 0.84) table.z.drop(i, j);
        }
    }
    return table;
}

void expect_same_path(const FitSurfaceReport& made, const FitSurfaceReport& want,
                      std::size_t steps) {
    ASSERT_GE(made.path.size(), steps);
    ASSERT_GE(want.path.size(), steps);
    for (std::size_t k = 0; k < steps; ++k) {
        EXPECT_EQ(made.path[k].intervals, want.path[k].intervals);
        EXPECT_NEAR(made.path[k].delta2 / want.path[k].delta2, 1, 1e-10);
    }
}

/// Infinite errors in place of missing nodes: errors of their own make every step see all nodes.
TEST(MaskedSearch, StepsAsOneThatSeesEveryNode) {
    SurfaceTable table = holed(300, 240, 0.02);
    FitSurfaceOptions options;
    options.sigma = 0.02;
    const SurfaceFit quick = fit_surface(table.view(), options);
    for (std::size_t i = 0; i < 300; ++i) {
        for (std::size_t j = 0; j < 240; ++j) {
            const bool is_there = table.z.view().has(i, j);
            table.sigma.push_back(is_there ? 0.02 : std::numeric_limits<double>::infinity());
            table.z(i, j) = is_there ? table.z(i, j) : 1;
        }
    }
    const SurfaceFit each = fit_surface(table.view(), {});
    EXPECT_GT(each.report.path.size(), 30u);
    EXPECT_TRUE(quick.report.path.front().psi.empty());
    EXPECT_FALSE(each.report.path.front().psi.empty());
    EXPECT_EQ(quick.report.breaks_x, each.report.breaks_x);
    EXPECT_EQ(quick.report.breaks_y, each.report.breaks_y);
    expect_same_path(quick.report, each.report, each.report.path.size());
}

TEST(MaskedSearch, EndsWithTheFitOverItsLines) {
    const SurfaceTable table = holed(300, 240, 0.02);
    for (const int degree : {1, 3, 6}) {
        FitSurfaceOptions options;
        options.degree = degree;
        const SurfaceFit found = fit_surface(table.view(), options);
        const FitSurfaceReport& report = found.report;
        for (const SurfaceStep& step : report.path) {
            if (step.intervals == report.intervals) {
                EXPECT_NEAR(step.delta2 / report.delta2, 1, 1e-10);
            }
        }
        options.knots = SurfaceKnots::given;
        options.x_knots = report.breaks_x;
        options.y_knots = report.breaks_y;
        const SurfaceFit again = fit_surface(table.view(), options);
        EXPECT_NEAR(report.delta2 / again.report.delta2, 1, 1e-10);
        EXPECT_EQ(report.psi, again.report.psi);
    }
}

/// A step a few rows wide: its strips are halved beyond those that were read.
TEST(MaskedSearch, HalvesOnWhereTheGridIsFinest) {
    const auto step = [](double x, double y) { return std::tanh(400 * (x - 0.4137)) * (1 + y); };
    SurfaceTable table = surface_of(step, 900, 100, 0.001);
    for (std::size_t k = 0; k < 200; ++k) table.z.drop(37 * k % 900, 11 * k % 100);
    FitSurfaceOptions options;
    options.sigma = 0.001;
    const SurfaceFit whole = fit_surface(table.view(), options);
    EXPECT_LE(narrowest_strip(whole.report), 1.0 / 256);
    EXPECT_LT(*whole.report.sigma2, 1.05);
}

void expect_same(const SurfaceFit& made, const SurfaceFit& want) {
    EXPECT_EQ(made.report.knots_x, want.report.knots_x);
    EXPECT_EQ(made.report.knots_y, want.report.knots_y);
    EXPECT_EQ(made.report.psi, want.report.psi);
    EXPECT_EQ(made.report.status, want.report.status);
    EXPECT_EQ(made.report.missing, want.report.missing);
    EXPECT_EQ(made.report.samples, want.report.samples);
    EXPECT_EQ(made.report.undetermined, want.report.undetermined);
    EXPECT_NEAR(made.report.delta2 / want.report.delta2, 1, 1e-10);
    const std::span<const double> a = made.surface.coefficients(), b = want.surface.coefficients();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-7);
}

TEST(MaskedStream, IsTheGridInMemory) {
    const SurfaceTable table = holed(500, 400, 0.02);
    FitSurfaceOptions options;
    for (const bool knows_sigma : {true, false}) {
        if (knows_sigma) options.sigma = 0.02;
        const SurfaceFit whole = fit_surface(table.view(), options);
        for (const std::size_t rows : {7, 1024}) {
            const SurfaceFit made = fit_surface(stream_of(table, rows), options);
            expect_same(made, whole);
            expect_same_path(made.report, whole.report, whole.report.path.size());
        }
        options = {};
    }
}

TEST(MaskedStream, FitsOverLinesThatAreGiven) {
    const SurfaceTable table = holed(300, 240, 0.02);
    FitSurfaceOptions options;
    options.knots = SurfaceKnots::given;
    options.x_knots = {0.25, 0.5, 0.5, 0.7};
    options.y_knots = {0.1, 0.6};
    expect_same(fit_surface(stream_of(table, 11), options), fit_surface(table.view(), options));
}

TEST(MaskedStream, TellsWhatAHoleLeavesOpen) {
    const SurfaceTable table = holed(300, 240, 0.02);
    FitSurfaceOptions options;
    options.knots = SurfaceKnots::equal;
    options.intervals = {60, 60};
    options.sigma = 0.02;
    const SurfaceFit made = fit_surface(stream_of(table), options);
    const SurfaceFit whole = fit_surface(table.view(), options);
    EXPECT_EQ(made.report.status, Status::rank_deficient);
    EXPECT_GT(made.report.undetermined.size(), 10u);
    EXPECT_EQ(made.report.undetermined, whole.report.undetermined);
    EXPECT_NEAR(made.report.delta2 / whole.report.delta2, 1, 1e-10);
    EXPECT_EQ(made.report.notes, whole.report.notes);
}

TEST(MaskedStream, WeighsRowsAndColumns) {
    const SurfaceTable table = holed(300, 240, 0.02);
    const UnevenErrors errors(table);
    expect_same(fit_surface(errors.of(stream_of(table, 50)), {}),
                fit_surface(errors.of(table.view()), {}));
}

TEST(MaskedStream, NeedsAHeight) {
    SurfaceTable table = surface_of(land, 300, 240);
    for (std::size_t i = 0; i < 300; ++i) {
        for (std::size_t j = 0; j < 240; ++j) table.z.drop(i, j);
    }
    EXPECT_EQ(code_of([&] { fit_surface(stream_of(table), {}); }), "fit.too-few");
}

}  // namespace fit_surface_masked_test
}  // namespace batten
