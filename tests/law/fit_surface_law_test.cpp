#include "surface_samples.hpp"

namespace batten {
namespace fit_surface_law_test {

using namespace testing;

double hills(double x, double y) {
    return std::exp(-8 * (x - 0.4) * (x - 0.4)) * (2 + std::sin(5 * y)) + x * y;
}

SurfaceTable hilly(std::uint64_t seed = 3) { return surface_of(hills, 41, 33, 0.02, seed); }

FitSurfaceOptions known_errors() {
    FitSurfaceOptions options;
    options.sigma = 0.02;
    return options;
}

TEST(SurfaceLaw, PowersOfTwoPassThroughExactly) {
    const SurfaceTable table = hilly();
    SurfaceTable scaled = table;
    for (double& x : scaled.x) x *= 8;
    for (double& y : scaled.y) y *= 0.25;
    for (std::size_t i = 0; i < 41; ++i) {
        for (std::size_t j = 0; j < 33; ++j) scaled.z(i, j) *= 1024;
    }
    FitSurfaceOptions options = known_errors();
    const SurfaceFit a = fit_surface(table.view(), options);
    options.sigma = 0.02 * 1024;
    const SurfaceFit b = fit_surface(scaled.view(), options);
    ASSERT_EQ(a.report.path.size(), b.report.path.size());
    ASSERT_EQ(a.surface.coefficients().size(), b.surface.coefficients().size());
    EXPECT_EQ(a.report.delta2, b.report.delta2);
    for (std::size_t k = 0; k < a.surface.coefficients().size(); ++k) {
        EXPECT_EQ(a.surface.coefficients()[k] * 1024, b.surface.coefficients()[k]);
    }
}

TEST(SurfaceLaw, ExchangingTheAxesExchangesTheSurface) {
    const SurfaceTable table = hilly();
    SurfaceTable turned{table.y, table.x};
    turned.z = Grid(33, 41);
    for (std::size_t i = 0; i < 41; ++i) {
        for (std::size_t j = 0; j < 33; ++j) turned.z(j, i) = table.z(i, j);
    }
    FitSurfaceOptions options = known_errors();
    options.knots = SurfaceKnots::equal;
    options.intervals = {7, 5};
    const SurfaceFit a = fit_surface(table.view(), options);
    options.intervals = {5, 7};
    const SurfaceFit b = fit_surface(turned.view(), options);
    for (std::size_t i = 0; i < a.surface.x_basis().size(); ++i) {
        for (std::size_t j = 0; j < a.surface.y_basis().size(); ++j) {
            EXPECT_NEAR(a.surface.coefficient(i, j), b.surface.coefficient(j, i), 1e-12);
        }
    }
}

TEST(SurfaceLaw, TheGradientVanishesAtTheAnswer) {
    SurfaceTable table = hilly();
    for (std::size_t k = 0; k < 300; ++k) table.z.drop((k * 7) % 41, (k * 13) % 33);
    Random random(5);
    table.sigma.resize(41 * 33);
    for (double& s : table.sigma) s = random.within(0.01, 0.05);
    FitSurfaceOptions options;
    options.knots = SurfaceKnots::equal;
    options.intervals = {6, 5};
    const SurfaceFit made = fit_surface(table.view(), options);
    EXPECT_GT(made.report.iterations, 0);
    const BSplineBasis &bx = made.surface.x_basis(), &by = made.surface.y_basis();
    std::vector<double> gradient(bx.size() * by.size(), 0.0), scale(gradient.size(), 0.0);
    std::vector<double> a(4), b(4);
    double delta2 = 0;
    for (std::size_t i = 0; i < 41; ++i) {
        for (std::size_t j = 0; j < 33; ++j) {
            if (!table.z.has(i, j)) continue;
            const double w = 1 / table.sigma[i * 33 + j];
            const double e = w * (table.z(i, j) - made.surface(table.x[i], table.y[j]));
            delta2 += e * e;
            bx.nonzero(table.x[i], 0, a);
            by.nonzero(table.y[j], 0, b);
            const std::size_t f = bx.span_of(table.x[i]) - 3, g = by.span_of(table.y[j]) - 3;
            for (std::size_t k = 0; k < 16; ++k) {
                const double column = w * a[k / 4] * b[k % 4];
                const std::size_t at = (f + k / 4) * by.size() + g + k % 4;
                gradient[at] += e * column;
                scale[at] += column * column;
            }
        }
    }
    EXPECT_NEAR(made.report.delta2, delta2, 1e-11 * delta2);
    for (std::size_t k = 0; k < gradient.size(); ++k) {
        EXPECT_LE(std::fabs(gradient[k]), 1e-7 * std::sqrt(scale[k] * delta2));
    }
}

TEST(SurfaceLaw, ErrorsThatAreAProductGiveTheSameAsErrorsOfEachNode) {
    SurfaceTable table = hilly();
    std::vector<double> nu(41), theta(33);
    for (std::size_t i = 0; i < 41; ++i) nu[i] = 0.01 + 0.001 * static_cast<double>(i);
    for (std::size_t j = 0; j < 33; ++j) theta[j] = 1 + 0.1 * static_cast<double>(j % 4);
    FitSurfaceOptions options;
    options.knots = SurfaceKnots::equal;
    options.intervals = {6, 5};
    SurfaceSamples samples = table.view();
    samples.x_sigma = nu;
    samples.y_sigma = theta;
    const SurfaceFit a = fit_surface(samples, options);
    table.sigma.resize(41 * 33);
    for (std::size_t i = 0; i < 41; ++i) {
        for (std::size_t j = 0; j < 33; ++j) table.sigma[i * 33 + j] = nu[i] * theta[j];
    }
    const SurfaceFit b = fit_surface(table.view(), options);
    table.sigma[0] *= 1 + 1e-9;
    const SurfaceFit c = fit_surface(table.view(), options);
    EXPECT_EQ(b.report.iterations, 0);
    EXPECT_GT(c.report.iterations, 0);
    EXPECT_NEAR(a.report.delta2, b.report.delta2, 1e-10 * a.report.delta2);
    EXPECT_NEAR(a.report.delta2, c.report.delta2, 1e-6 * a.report.delta2);
    for (std::size_t k = 0; k < a.surface.coefficients().size(); ++k) {
        EXPECT_NEAR(a.surface.coefficients()[k], b.surface.coefficients()[k], 1e-10);
        EXPECT_NEAR(a.surface.coefficients()[k], c.surface.coefficients()[k], 1e-6);
    }
}

TEST(SurfaceLaw, AGridIsWhatSinglePointsAre) {
    const SplineSurface s = fit_surface(hilly().view(), known_errors()).surface;
    const std::vector<double> x = even_places({0, 1}, 601), y = even_places({0, 1}, 777);
    for (const Partial d : {Partial{0, 0}, Partial{1, 0}, Partial{1, 1}, Partial{0, 2}}) {
        const Grid grid = s.evaluate(x, y, d);
        for (std::size_t i = 0; i < x.size(); i += 37) {
            for (std::size_t j = 0; j < y.size(); j += 41) {
                const double want = s(x[i], y[j], d);
                EXPECT_NEAR(grid(i, j), want, 1e-12 * (1 + std::fabs(want)));
            }
        }
    }
}

}  // namespace fit_surface_law_test
}  // namespace batten
