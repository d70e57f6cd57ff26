#include <numeric>

#include "batten/make/fit_scattered.hpp"
#include "random.hpp"
#include "surface_samples.hpp"

/// Knot lines of surfaces through scattered points that are moved.
namespace batten {
namespace fit_scattered_free_test {

using namespace testing;

struct Rows3 {
    std::vector<double> x, y, z;
    ScatteredSamples view() const { return {x, y, z}; }
};

/// Heights of a function at random places of the unit square, and its corners.
template <class F>
Rows3 scattered(F f, int count, double noise) {
    Random random(11);
    Noise normal(5);
    Rows3 rows{{0, 0, 1, 1}, {0, 1, 0, 1}, {}};
    for (int k = 4; k < count; ++k) {
        rows.x.push_back(random.within(0, 1));
        rows.y.push_back(random.within(0, 1));
    }
    for (std::size_t k = 0; k < rows.x.size(); ++k) {
        rows.z.push_back(f(rows.x[k], rows.y[k]) + (noise > 0 ? noise * normal.normal() : 0));
    }
    return rows;
}

FitSurfaceOptions strips(double m, double n, SurfaceKnots knots) {
    FitSurfaceOptions options;
    options.knots = knots;
    options.intervals = {m, n};
    options.sigma = 0.02;
    return options;
}

double ridge(double x, double y) {
    const double off = (x - 0.37) / 0.04;
    return std::exp(-off * off) * (1 + 0.5 * y) + 0.3 * std::sin(3 * y);
}

TEST(FreeLinesOfScatteredPoints, GatherAtARidge) {
    const Rows3 rows = scattered(ridge, 3000, 0.02);
    const SurfaceFit equal = fit_scattered(rows.view(), strips(8, 2, SurfaceKnots::equal));
    const SurfaceFit moved = fit_scattered(rows.view(), strips(8, 2, SurfaceKnots::free));
    EXPECT_EQ(moved.report.status, Status::met);
    EXPECT_EQ(moved.report.parameters, equal.report.parameters);
    EXPECT_EQ(moved.report.parameters_charged, equal.report.parameters + 8);
    EXPECT_LT(moved.report.delta2, 0.2 * equal.report.delta2);
    EXPECT_NEAR(*moved.report.sigma2, 1, 0.1);
    const std::vector<double>& x = moved.report.breaks_x;
    EXPECT_GE(std::count_if(x.begin(), x.end(), [](double t) { return std::fabs(t - 0.37) < 0.12; }),
              5);
    // No line gains by going a little to either side.
    for (std::size_t line = 1; line + 1 < x.size(); ++line) {
        if (x[line] - x[line - 1] < 0.01 || x[line + 1] - x[line] < 0.01) continue;
        for (const double h : {-2e-3, 2e-3}) {
            FitSurfaceOptions given = strips(8, 2, SurfaceKnots::given);
            given.intervals = {};
            given.x_knots = x;
            given.y_knots = moved.report.breaks_y;
            given.x_knots[line] += h;
            EXPECT_GE(fit_scattered(rows.view(), given).report.delta2,
                      moved.report.delta2 * (1 - 1e-5));
        }
    }
}

TEST(FreeLinesOfScatteredPoints, FindThoseThatTheSurfaceHas) {
    const BSplineBasis x = BSplineBasis::over(std::vector<double>{0, 0.3, 0.62, 1}, 3);
    const BSplineBasis y = BSplineBasis::over(std::vector<double>{0, 0.45, 1}, 3);
    Random random(8);
    std::vector<double> c;
    for (std::size_t k = 0; k < x.size() * y.size(); ++k) c.push_back(random.within(-1, 1));
    const SplineSurface truth(x, y, c);
    const Rows3 rows = scattered([&](double a, double b) { return truth(a, b); }, 1500, 0);
    const SurfaceFit equal = fit_scattered(rows.view(), strips(3, 2, SurfaceKnots::equal));
    const SurfaceFit moved = fit_scattered(rows.view(), strips(3, 2, SurfaceKnots::free));
    EXPECT_LT(moved.report.delta2, 1e-6 * equal.report.delta2);
    EXPECT_NEAR(moved.report.breaks_x[1], 0.3, 1e-6);
    EXPECT_NEAR(moved.report.breaks_x[2], 0.62, 1e-6);
    EXPECT_NEAR(moved.report.breaks_y[1], 0.45, 1e-6);
}

/// The grid's descent does not mix the directions, this one does: two ways to one minimum.
TEST(FreeLinesOfScatteredPoints, AreThoseOfTheGridWhereTheyFillOne) {
    const SurfaceTable table = surface_of(ridge, 60, 40, 0.02);
    Rows3 rows;
    for (std::size_t i = 0; i < 60; ++i) {
        for (std::size_t j = 0; j < 40; ++j) {
            rows.x.push_back(table.x[i]);
            rows.y.push_back(table.y[j]);
            rows.z.push_back(table.z(i, j));
        }
    }
    const FitSurfaceOptions options = strips(6, 3, SurfaceKnots::free);
    const SurfaceFit grid = fit_surface(table.view(), options);
    const SurfaceFit cloud = fit_scattered(rows.view(), options);
    EXPECT_NEAR(cloud.report.delta2 / grid.report.delta2, 1, 1e-3);
    EXPECT_EQ(cloud.report.parameters_charged, grid.report.parameters_charged);
}

/// Where a quarter of the square is empty, lines move without making more coefficients open.
TEST(FreeLinesOfScatteredPoints, LeaveNoCoefficientOpenThatWasNot) {
    Rows3 rows = scattered(ridge, 3000, 0.02), holed;
    for (std::size_t k = 0; k < rows.x.size(); ++k) {
        if (k >= 4 && rows.x[k] > 0.5 && rows.y[k] > 0.5) continue;
        holed.x.push_back(rows.x[k]);
        holed.y.push_back(rows.y[k]);
        holed.z.push_back(rows.z[k]);
    }
    const SurfaceFit equal = fit_scattered(holed.view(), strips(8, 4, SurfaceKnots::equal));
    const SurfaceFit moved = fit_scattered(holed.view(), strips(8, 4, SurfaceKnots::free));
    EXPECT_LT(moved.report.delta2, 0.5 * equal.report.delta2);
    EXPECT_LE(moved.report.undetermined.size(), equal.report.undetermined.size());
}

}  // namespace fit_scattered_free_test
}  // namespace batten
