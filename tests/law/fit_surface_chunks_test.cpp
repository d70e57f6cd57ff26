#include "batten/make/fit_surface_chunks.hpp"
#include "surface_samples.hpp"

/// Grids that come in blocks of rows.
namespace batten {
namespace fit_surface_chunks_test {

using namespace testing;

SurfaceTable hills(std::size_t m, std::size_t n) {
    const auto f = [](double x, double y) { return std::sin(5 * x) * std::cos(4 * y) + x * y * y; };
    return surface_of(f, m, n, 0.05);
}

/// Errors that differ from line to line.
std::vector<double> uneven(std::size_t count) {
    std::vector<double> sigma;
    for (std::size_t i = 0; i < count; ++i) sigma.push_back(0.05 * (1 + 0.5 * std::sin(static_cast<double>(i))));
    return sigma;
}

FitSurfaceOptions six_by_five(int degree) {
    FitSurfaceOptions options;
    options.degree = degree;
    options.knots = SurfaceKnots::equal;
    options.intervals = {6, 5};
    return options;
}

std::span<const double> rows_of(const SurfaceTable& table, std::size_t first, std::size_t count) {
    return table.z.view().values().subspan(first * table.y.size(), count * table.y.size());
}

SurfaceStream stream_of(const SurfaceTable& table) {
    return {table.x, table.y, [&](std::size_t first, std::span<double> z) {
                const auto rows = rows_of(table, first, z.size() / table.y.size());
                std::copy(rows.begin(), rows.end(), z.begin());
            }};
}

void expect_same(const SurfaceFit& made, const SurfaceFit& want) {
    const std::span<const double> a = made.surface.coefficients(), b = want.surface.coefficients();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-12);
    EXPECT_NEAR(made.report.delta2 / want.report.delta2, 1, 1e-12);
    EXPECT_NEAR(made.report.bic, want.report.bic,
                1e-12 * (want.report.bic + static_cast<double>(want.report.samples)));
    EXPECT_EQ(made.report.samples, want.report.samples);
    EXPECT_EQ(made.report.breaks_x, want.report.breaks_x);
    EXPECT_EQ(made.report.parameters, want.report.parameters);
    EXPECT_EQ(made.report.status, want.report.status);
}

TEST(SurfaceChunks, OfAnySizeGiveTheFitOfTheWhole) {
    const SurfaceTable table = hills(61, 40);
    const std::vector<double> x_sigma = uneven(61), y_sigma = uneven(40);
    for (const int degree : {0, 1, 3, 5}) {
        SCOPED_TRACE(degree);
        const SurfaceFit whole = fit_surface({table.x, table.y, table.z, x_sigma, y_sigma},
                                             six_by_five(degree));
        for (const std::size_t size : {1, 7, 61}) {
            SurfaceChunk chunk(whole.surface.x_basis(), whole.surface.y_basis(),
                               {table.y, y_sigma});
            SurfaceResiduals residuals(whole.surface, {table.y, y_sigma});
            for (std::size_t first = 0; first < 61; first += size) {
                const std::size_t count = std::min<std::size_t>(size, 61 - first);
                const SurfaceRows rows{std::span(table.x).subspan(first, count),
                                       rows_of(table, first, count),
                                       std::span(x_sigma).subspan(first, count)};
                chunk.add(rows);
                residuals.add(rows);
            }
            SurfaceFit made = chunk.solve();
            expect_same(made, whole);
            EXPECT_TRUE(made.report.psi.empty());
            residuals.fill(made.report);
            expect_same(made, whole);
            EXPECT_EQ(made.report.psi, whole.report.psi);
            EXPECT_DOUBLE_EQ(made.report.max_residual, whole.report.max_residual);
        }
    }
}

TEST(SurfaceChunks, MergeInAnyOrder) {
    const SurfaceTable table = hills(60, 30);
    FitSurfaceOptions options = six_by_five(3);
    options.sigma = 0.05;
    const SurfaceFit whole = fit_surface(table.view(), options);
    const SurfaceChunk none(whole.surface.x_basis(), whole.surface.y_basis(), {table.y});
    std::vector<SurfaceChunk> chunks(4, none);
    SurfaceResiduals residuals(whole.surface, {table.y}), others = residuals;
    for (std::size_t c = 0; c < 4; ++c) {
        const SurfaceRows rows{std::span(table.x).subspan(15 * c, 15), rows_of(table, 15 * c, 15)};
        chunks[c].add(rows, 0.05);
        (c % 2 == 0 ? residuals : others).add(rows, 0.05);
    }
    SurfaceChunk left = chunks[0], right = chunks[3];
    left.merge(chunks[1]);
    right.merge(chunks[2]);
    right.merge(left);
    for (std::size_t c = 1; c < 4; ++c) chunks[0].merge(chunks[c]);
    expect_same(chunks[0].solve(), whole);
    SurfaceFit made = right.solve();
    residuals.merge(others);
    residuals.fill(made.report);
    expect_same(made, whole);
    EXPECT_EQ(made.report.psi, whole.report.psi);
    EXPECT_NEAR(*made.report.chi2_p, *whole.report.chi2_p, 1e-11);
}

TEST(SurfaceChunks, KeepSumsOfSquaresWhereNothingIsLeft) {
    // A bicubic is met by the splines: delta2 is that of rounding, not of cancelling sums.
    const auto f = [](double x, double y) { return 1e6 + x * x * x * y - 3 * y * y; };
    const SurfaceTable table = surface_of(f, 50, 40);
    const SurfaceFit whole = fit_surface(table.view(), six_by_five(3));
    SurfaceChunk chunk(whole.surface.x_basis(), whole.surface.y_basis(), {table.y});
    chunk.add({table.x, table.z.view().values()});
    EXPECT_LE(chunk.solve().report.delta2, 2000 * 1e-18 * 1e6 * 1e6 / 1e12 * 100);
}

TEST(SurfaceChunks, ContinueTheSurfaceWhereRowsAreMissing) {
    const auto f = [](double x, double y) { return x * y; };
    const SurfaceTable table = surface_of(f, 41, 30);
    const BSplineBasis x = BSplineBasis::over(even_places({0, 1}, 11), 3);
    const BSplineBasis y = BSplineBasis::over(even_places({0, 1}, 5), 3);
    SurfaceChunk chunk(x, y, {table.y});
    chunk.add({std::span(table.x).first(10), rows_of(table, 0, 10)});
    chunk.add({std::span(table.x).last(10), rows_of(table, 31, 10)});
    const SurfaceFit made = chunk.solve();
    EXPECT_EQ(made.report.status, Status::rank_deficient);
    // Without rows in (0.225, 0.775): functions 6, living on [0.3, 0.7], and its neighbours.
    ASSERT_FALSE(made.report.undetermined.empty());
    EXPECT_EQ(made.report.undetermined.size() % y.size(), 0u);
    for (const double at : {0.1, 0.5, 0.9}) EXPECT_NEAR(made.surface(at, 0.7), 0.7 * at, 1e-6);
}

TEST(StreamedSurface, IsTheSurfaceOfTheGridInMemory) {
    // Blocks of 2^20 numbers: 29 rows here.
    const SurfaceTable table = hills(33, 36'000);
    for (const bool knows_sigma : {true, false}) {
        FitSurfaceOptions options = six_by_five(3);
        if (knows_sigma) options.sigma = 0.05;
        const SurfaceFit whole = fit_surface(table.view(), options);
        const SurfaceFit made = fit_surface(stream_of(table), options);
        expect_same(made, whole);
        EXPECT_EQ(made.report.psi, whole.report.psi);
        EXPECT_EQ(made.report.sigma_source, whole.report.sigma_source);
        EXPECT_NEAR(*made.report.sigma, *whole.report.sigma, 1e-14);
        EXPECT_NEAR(made.report.separability.product, whole.report.separability.product, 1e-13);
        EXPECT_EQ(made.report.chi2_p.has_value(), knows_sigma);
    }
}

}  // namespace fit_surface_chunks_test
}  // namespace batten
