#include <algorithm>
#include <numeric>

#include "batten/make/fit_scattered.hpp"
#include "errors.hpp"
#include "random.hpp"
#include "surface_samples.hpp"

namespace batten {
namespace fit_scattered_test {

using namespace testing;

/// The nodes of a grid as rows, in an order of their own.
struct Rows3 {
    std::vector<double> x, y, z, sigma;
    ScatteredSamples view() const { return {x, y, z, sigma}; }
};

Rows3 rows_of(const SurfaceTable& table) {
    Rows3 rows;
    const std::size_t nx = table.x.size(), ny = table.y.size(), count = nx * ny;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t node = k * 7919 % count;
        rows.x.push_back(table.x[node / ny]);
        rows.y.push_back(table.y[node % ny]);
        rows.z.push_back(table.z(node / ny, node % ny));
    }
    return rows;
}

double bumps(double x, double y) { return std::sin(5 * x) * std::cos(4 * y) + x * y; }

TEST(ScatteredSurface, OnAGridIsTheGridsOwnFit) {
    const SurfaceTable table = surface_of(bumps, 41, 37, 0.05);
    FitSurfaceOptions options;
    options.sigma = 0.05;
    options.knots = SurfaceKnots::equal;
    options.intervals = {6, 5};
    const SurfaceFit grid = fit_surface(table.view(), options);
    const SurfaceFit cloud = fit_scattered(rows_of(table).view(), options);
    EXPECT_NEAR(cloud.report.delta2, grid.report.delta2, 1e-9 * grid.report.delta2);
    for (std::size_t k = 0; k < grid.surface.coefficients().size(); ++k) {
        EXPECT_NEAR(cloud.surface.coefficients()[k], grid.surface.coefficients()[k], 1e-9);
    }
    EXPECT_EQ(cloud.report.status, Status::met);
    EXPECT_EQ(cloud.report.samples, 41u * 37u);
}

TEST(ScatteredSurface, FindsItsLinesAndMeetsTheTruth) {
    Random random(3);
    Rows3 rows;
    for (int k = 0; k < 2000; ++k) {
        rows.x.push_back(random.within(0, 2));
        rows.y.push_back(random.within(-1, 1));
        rows.z.push_back(bumps(rows.x.back(), rows.y.back()) + random.within(-0.02, 0.02));
        rows.sigma.push_back(0.02 / std::sqrt(3.0));
    }
    const SurfaceFit made = fit_scattered(rows.view(), {});
    EXPECT_EQ(made.report.status, Status::met);
    EXPECT_NEAR(*made.report.sigma2, 1, 0.1);
    EXPECT_LE(made.report.parameters, 120);
    for (double x = 0.1; x < 2; x += 0.2) {
        for (double y = -0.9; y < 1; y += 0.2) EXPECT_NEAR(made.surface(x, y), bumps(x, y), 0.02);
    }
}

TEST(ScatteredSurface, TellsWhichCoefficientsAGapSwallows) {
    Random random(4);
    Rows3 rows;
    while (rows.x.size() < 3000) {
        const double x = random.within(0, 1), y = random.within(0, 1);
        if (std::fabs(x - 0.5) < 0.3 && std::fabs(y - 0.5) < 0.3) continue;
        rows.x.push_back(x);
        rows.y.push_back(y);
        rows.z.push_back(1 + 2 * x - 3 * y);
    }
    FitSurfaceOptions options;
    options.sigma = 1;
    options.knots = SurfaceKnots::equal;
    options.intervals = {12, 12};
    const SurfaceFit made = fit_scattered(rows.view(), options);
    EXPECT_EQ(made.report.status, Status::rank_deficient);
    EXPECT_FALSE(made.report.undetermined.empty());
    // A plane goes on across the gap.
    EXPECT_NEAR(made.surface(0.5, 0.5), 0.5, 1e-5);
    EXPECT_NEAR(made.surface(0.05, 0.9), -1.6, 1e-9);
}

TEST(ScatteredSurface, EndsItsSearchWhereSamplesAreTooFew) {
    Random random(8);
    Rows3 rows;
    for (int k = 0; k < 92; ++k) {
        rows.x.push_back(random.within(0, 1));
        rows.y.push_back(random.within(0, 1));
        rows.z.push_back(random.within(-1, 1));
    }
    for (const SurfaceKnots knots : {SurfaceKnots::automatic, SurfaceKnots::equal}) {
        FitSurfaceOptions options;
        options.sigma = 1e-4;
        options.knots = knots;
        EXPECT_LE(fit_scattered(rows.view(), options).report.parameters, 92);
    }
}

TEST(ScatteredSurface, MeasuresInTheErrorsThatAreLeftWhereNoneAreKnown) {
    const SurfaceTable table = surface_of(bumps, 31, 32, 0.05);
    const Rows3 rows = rows_of(table);
    const FitSurfaceReport made = fit_scattered(rows.view(), {}).report;
    const double degrees = static_cast<double>(made.samples) - made.parameters;
    EXPECT_NEAR(made.delta2, degrees, 1e-9 * degrees);
    EXPECT_NEAR(*made.sigma2, 1, 1e-12);
    EXPECT_NEAR(*made.sigma, 0.05, 0.005);
    const FitCriteria same =
        fit_criteria(made.delta2, made.samples, made.parameters, SigmaKnowledge::unknown);
    EXPECT_EQ(made.bic, same.bic);
    // The best of the path is what was chosen.
    const auto best = std::min_element(
        made.path.begin(), made.path.end(),
        [](const SurfaceStep& a, const SurfaceStep& b) { return a.bic < b.bic; });
    EXPECT_EQ(best->intervals, made.intervals);
    EXPECT_NEAR(best->bic, made.bic, 1e-6);
}

TEST(ScatteredSurface, ScalesExactly) {
    const SurfaceTable table = surface_of(bumps, 21, 22, 0.05);
    const Rows3 rows = rows_of(table);
    Rows3 larger = rows;
    for (double& z : larger.z) z *= 1024;
    FitSurfaceOptions options;
    options.sigma = 0.05;
    const SurfaceFit one = fit_scattered(rows.view(), options);
    options.sigma = 0.05 * 1024;
    const SurfaceFit two = fit_scattered(larger.view(), options);
    EXPECT_EQ(two.report.knots_x, one.report.knots_x);
    for (std::size_t k = 0; k < one.surface.coefficients().size(); ++k) {
        EXPECT_EQ(two.surface.coefficients()[k], 1024 * one.surface.coefficients()[k]);
    }
}

TEST(ScatteredSurface, RefusesWhatHasNoAnswer) {
    const std::vector<double> x{0, 1, 2, 3}, y{0, 1, 0, 1}, z{1, 2, 3, 4}, same{1, 1, 1, 1};
    const auto refused = [](ScatteredSamples samples, FitSurfaceOptions options = {}) {
        return code_of([&] { fit_scattered(samples, options); });
    };
    EXPECT_EQ(refused({x, y, {z.data(), 3}}), "fit-surface.sizes");
    EXPECT_EQ(refused({x, same, z}), "fit.x-equal");
    EXPECT_EQ(refused({x, y, z}), "fit.too-few");
    const std::vector<double> bad{1, 2, nan, 3}, sigma{1, 1, 0, 1};
    EXPECT_EQ(refused({x, y, bad}), "points.not-finite");
    EXPECT_EQ(refused({x, y, z, sigma}), "fit.sigma");
    FitSurfaceOptions options;
    options.stop = StopRule::chi2;
    EXPECT_EQ(refused({x, y, z}, options), "fit.options");
    options.stop = StopRule::bic;
    options.knots = SurfaceKnots::free;
    EXPECT_EQ(refused({x, y, z}, options), "fit.too-few");
}

TEST(FreeKnotLines, LessenDelta2AsMuchAsTheReference) {
    SKIP_UNLESS_SHARED("reference/fitting/surface_equal.csv");
    const SurfaceTable table = surface_table("surface_equal");
    FitSurfaceOptions options;
    options.sigma = 1;
    options.rule = StripRule::marginal;
    options.delta2 = 2816.6;
    const double inserted = fit_surface(table.view(), options).report.delta2;
    options.knots = SurfaceKnots::free;
    const SurfaceFit made = fit_surface(table.view(), options);
    EXPECT_LE(made.report.delta2, 0.98 * inserted);
    EXPECT_LE(made.report.delta2, 1.001 * 2744.56);  // surface_reference.json, kprog3
    EXPECT_EQ(made.report.parameters_charged,
              made.report.parameters + made.report.intervals[0] + made.report.intervals[1] - 2);
    EXPECT_EQ(made.report.status, Status::met);
    // No line gains by going a little to either side.
    FitSurfaceOptions given;
    given.sigma = 1;
    const std::vector<double>& x = made.report.breaks_x;
    for (std::size_t line = 1; line + 1 < x.size(); line += 3) {
        if (x[line] - x[line - 1] < 1 || x[line + 1] - x[line] < 1) continue;
        for (const double h : {-0.02, 0.02}) {
            given.x_knots = made.report.breaks_x;
            given.y_knots = made.report.breaks_y;
            given.x_knots[line] += h;
            EXPECT_GE(fit_surface(table.view(), given).report.delta2,
                      made.report.delta2 * (1 - 1e-5));
        }
    }
}

}  // namespace fit_scattered_test
}  // namespace batten
