#include "errors.hpp"
#include "surface_samples.hpp"

namespace batten {
namespace fit_surface_bad_test {

using namespace testing;

SurfaceTable plain() {
    return surface_of([](double x, double y) { return x * y; }, 9, 8);
}

std::string refused(const SurfaceSamples& samples, const FitSurfaceOptions& options = {}) {
    return code_of([&] { fit_surface(samples, options); });
}

TEST(BadSurface, AxesThatDoNotRiseAreRefused) {
    SurfaceTable table = plain();
    table.x[3] = table.x[2];
    EXPECT_EQ(refused(table.view()), "fit-surface.axis");
    table.x[3] = nan;
    EXPECT_EQ(refused(table.view()), "points.not-finite");
    SurfaceTable one = plain();
    one.x.resize(1);
    one.z = Grid(1, 8);
    EXPECT_EQ(refused(one.view()), "fit-surface.axis");
}

TEST(BadSurface, WrongSizesAreRefused) {
    SurfaceTable table = plain();
    table.x.push_back(2);
    EXPECT_EQ(refused(table.view()), "fit-surface.sizes");
    SurfaceTable errors = plain();
    errors.sigma.assign(5, 1.0);
    EXPECT_EQ(refused(errors.view()), "fit-surface.sizes");
    errors.sigma.assign(72, 1.0);
    errors.sigma[7] = 0;
    EXPECT_EQ(refused(errors.view()), "fit.sigma");
    errors.sigma[7] = nan;
    EXPECT_EQ(refused(errors.view()), "fit.sigma");
}

TEST(BadSurface, HeightsThatAreNoNumbersAreRefused) {
    SurfaceTable table = plain();
    table.z(2, 2) = nan;
    EXPECT_EQ(refused(table.view()), "points.not-finite");
    table.z.drop(2, 2);
    EXPECT_EQ(refused(table.view()), "none");
    for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t j = 0; j < 8; ++j) table.z.drop(i, j);
    }
    EXPECT_EQ(refused(table.view()), "fit.too-few");
}

TEST(BadSurface, StripsBeyondTheDataAreRefused) {
    const SurfaceTable table = plain();
    FitSurfaceOptions options;
    options.knots = SurfaceKnots::equal;
    options.intervals = {7, 2};
    EXPECT_EQ(refused(table.view(), options), "fit.too-few");
    options.intervals = {2};
    EXPECT_EQ(refused(table.view(), options), "fit.intervals");
    options.intervals = {2, 1.5};
    EXPECT_EQ(refused(table.view(), options), "fit.intervals");
    options.intervals = {};
    options.x_knots = {0.5, 0.4};
    EXPECT_EQ(refused(table.view(), options), "fit.knots");
    options.x_knots = {0.5, 1.5};
    EXPECT_EQ(refused(table.view(), options), "fit.knots");
    options.x_knots = {0.5};
    EXPECT_EQ(refused(table.view(), options), "none");
    options.intervals = {2, 2};
    EXPECT_EQ(refused(table.view(), options), "fit.options");
    FitSurfaceOptions chances;
    chances.distribution = {0.9, 0.5};
    EXPECT_EQ(refused(table.view(), chances), "fit.distribution");
}

TEST(BadSurface, NumbersBeyondADoubleAreRefused) {
    SurfaceTable table = surface_of([](double x, double y) { return x < 0.5 ? 1e308 : -1e308 * y; },
                                    9, 8);
    FitSurfaceOptions options;
    options.sigma = 1;
    EXPECT_EQ(refused(table.view(), options), "number.overflow");
}

}  // namespace fit_surface_bad_test
}  // namespace batten
