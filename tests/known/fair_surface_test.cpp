#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/make/fair_surface.hpp"
#include "errors.hpp"
#include "surface_grids.hpp"

namespace batten {
namespace fair_surface_test {

using testing::bend_error;
using testing::distance_across;
using testing::lines;
using testing::surface_grid;
using testing::with_noise;
using Kind = testing::SurfaceKind;

struct Case {
    Kind kind;
    double noise;
    double gaussian;  ///< the error that the reference reaches with curvature Gauss-Newton
};

constexpr Case cases[] = {
    {Kind::sphere, 5e-4, 0.007},       {Kind::sphere, 2e-3, 0.022},
    {Kind::cylinder, 5e-4, 0.003},     {Kind::cylinder, 2e-3, 0.012},
    {Kind::pseudosphere, 5e-4, 0.007}, {Kind::pseudosphere, 2e-3, 0.026},
    {Kind::ruled, 5e-4, 0.006},        {Kind::ruled, 2e-3, 0.018},
};

TEST(FairSurface, TakesMostOfTheNoiseAwayAndEvensTheCurvature) {
    for (const Case& c : cases) {
        const Grid exact = surface_grid(c.kind), noisy = with_noise(exact, c.noise, 1);
        const SurfaceFairing made = fair_surface(noisy, {});
        EXPECT_LT(distance_across(made.grid, exact), distance_across(noisy, exact) / 7);
        EXPECT_LT(bend_error(made.grid, exact, gaussian_curvature), c.gaussian);
        EXPECT_NEAR(*made.report.sigma, c.noise, c.noise / 10);
        EXPECT_EQ(made.report.status, Status::met);
    }
}

TEST(FairSurface, KeepsACurvatureThatVaries) {
    const Grid exact = surface_grid(Kind::saddle), noisy = with_noise(exact, 2e-3, 1);
    const SurfaceFairing made = fair_surface(noisy, {});
    EXPECT_LT(distance_across(made.grid, exact), distance_across(noisy, exact) / 7);
    EXPECT_LT(bend_error(made.grid, exact, gaussian_curvature), 0.005);
    EXPECT_EQ(made.report.weight_curvature, 0);
}

TEST(FairSurface, EvensTheMeanCurvatureWhereAsked) {
    FairSurfaceOptions options;
    options.target = SurfaceTarget::mean;
    for (const Kind kind : {Kind::sphere, Kind::cylinder}) {
        const Grid exact = surface_grid(kind), noisy = with_noise(exact, 5e-4, 1);
        const SurfaceFairing made = fair_surface(noisy, options);
        EXPECT_LT(distance_across(made.grid, exact), distance_across(noisy, exact) / 20);
        EXPECT_LT(bend_error(made.grid, exact, mean_curvature), 5e-4);
        EXPECT_NEAR(std::fabs(made.report.mean_curvature.rms), kind == Kind::sphere ? 1 : 0.5, 1e-3);
    }
}

TEST(FairSurface, KeepsTheSpacingOfUnevenGrids) {
    // Every second gap twice as wide.
    const auto at = [](double i) { return testing::line_step * (i + (std::fmod(i + 16, 2) / 3)); };
    for (const Kind kind : {Kind::sphere, Kind::cylinder}) {
        const Grid exact = surface_grid(kind, at), noisy = with_noise(exact, 5e-4, 1);
        const SurfaceFairing made = fair_surface(noisy, {});
        EXPECT_LT(distance_across(made.grid, exact), distance_across(noisy, exact) / 7);
        double most = 0;
        for (std::size_t i = 0; i < lines; ++i) {
            for (int k = 0; k < 3; ++k) {
                most = std::fmax(most, std::fabs(made.grid(i, 16, k) - exact(i, 16, k)));
            }
        }
        EXPECT_LT(most, 4e-4);  // along the surface as well
        EXPECT_NEAR(bend_error(made.grid, exact, gaussian_curvature), 0, 0.007);
    }
}

TEST(FairSurface, TakesTheWeightOfCurvatureThatIsGiven) {
    const Grid exact = surface_grid(Kind::sphere), noisy = with_noise(exact, 5e-4, 1);
    double before = 1;
    for (const double weight : {0.0, 1.0, 100.0}) {
        FairSurfaceOptions options;
        options.weight_curvature = weight;
        const SurfaceFairing made = fair_surface(noisy, options);
        EXPECT_NEAR(*made.report.weight_curvature, weight, 1e-12 * weight);
        const CurvatureSpread& spread = made.report.gaussian_curvature;
        EXPECT_LT(spread.max - spread.min, before);
        before = spread.max - spread.min;
    }
}

FairSurfaceOptions paper_step(FilterRoot root) {
    FairSurfaceOptions options;
    options.engine = SurfaceEngine::filter;
    options.root = root;
    return options;
}

TEST(SurfaceFilter, LeavesSphereCylinderAndRuledPatchWhereTheyAre) {
    for (const Kind kind : {Kind::sphere, Kind::cylinder, Kind::ruled}) {
        const SurfaceFairing made =
            fair_surface(surface_grid(kind), paper_step(FilterRoot::nearest));
        EXPECT_LT(made.report.max_displacement, 1e-14);
        EXPECT_EQ(made.report.status, Status::met);
    }
}

TEST(SurfaceFilter, SaysWhereItIsUnstable) {
    const SurfaceFairing made =
        fair_surface(surface_grid(Kind::pseudosphere), paper_step(FilterRoot::nearest));
    EXPECT_GT(made.report.max_displacement, 1e-3);
    EXPECT_EQ(made.report.status, Status::not_converged);
    ASSERT_FALSE(made.report.notes.empty());
    EXPECT_NE(made.report.notes.front().find("unstable"), std::string::npos);
}

TEST(SurfaceFilter, RuinsASphereByTheRootOfThePaper) {
    const SurfaceFairing made =
        fair_surface(surface_grid(Kind::sphere), paper_step(FilterRoot::paper));
    EXPECT_NEAR(distance_across(made.grid, surface_grid(Kind::sphere)), 0.03, 0.001);
    EXPECT_EQ(made.report.status, Status::not_converged);
}

TEST(SurfaceFilter, DoesNotTakeNoiseAway) {
    const Grid exact = surface_grid(Kind::sphere), noisy = with_noise(exact, 5e-4, 1);
    const SurfaceFairing made = fair_surface(noisy, paper_step(FilterRoot::nearest));
    EXPECT_GT(distance_across(made.grid, exact), distance_across(noisy, exact));
    EXPECT_EQ(made.report.status, Status::not_converged);
}

TEST(FairSurface, KeepsTheBorderAsAskedAndScalesExactly) {
    const Grid noisy = with_noise(surface_grid(Kind::sphere), 1e-3, 2);
    Grid large = noisy;
    for (std::size_t i = 0; i < lines; ++i) {
        for (std::size_t j = 0; j < lines; ++j) {
            for (int k = 0; k < 3; ++k) large(i, j, k) *= 256;
        }
    }
    for (const Border border : {Border::g0, Border::g1, Border::g2}) {
        FairSurfaceOptions options;
        options.border = border;
        const Grid fair = fair_surface(noisy, options).grid, big = fair_surface(large, options).grid;
        const std::size_t held = 1 + static_cast<std::size_t>(border);
        for (std::size_t i = 0; i < lines; ++i) {
            for (std::size_t j = 0; j < lines; ++j) {
                const bool is_held =
                    i < held || j < held || i + held >= lines || j + held >= lines;
                if (is_held) {
                    EXPECT_EQ(fair(i, j, 2), noisy(i, j, 2));
                }
                EXPECT_EQ(256 * fair(i, j, 1), big(i, j, 1));
            }
        }
        EXPECT_NE(fair(16, 16, 2), noisy(16, 16, 2));
    }
}

TEST(FairSurface, RefusesGridsThatAreNoSurface) {
    const auto code = [](const Grid& grid, const FairSurfaceOptions& options = {}) {
        return testing::code_of([&] { fair_surface(grid, options); });
    };
    const Grid sphere = surface_grid(Kind::sphere);
    EXPECT_EQ(code(Grid(9, 9, 1)), "grid.dimension");
    EXPECT_EQ(code(Grid(6, 9, 3)), "grid.too-small");
    EXPECT_EQ(code(Grid(9, 9, 3)), "grid.repeated");
    Grid holed = sphere;
    holed.drop(4, 5);
    EXPECT_EQ(code(holed), "grid.holes");
    Grid broken = sphere;
    broken(3, 3, 1) = std::nan("");
    EXPECT_EQ(code(broken), "points.not-finite");
    Grid doubled = sphere;
    for (std::size_t j = 0; j < lines; ++j) {
        for (int k = 0; k < 3; ++k) doubled(5, j, k) = doubled(4, j, k);
    }
    EXPECT_EQ(code(doubled), "grid.repeated");
    FairSurfaceOptions options;
    options.sigma = -1;
    EXPECT_EQ(code(sphere, options), "option.range");
    options = {};
    options.weight_curvature = testing::nan;
    EXPECT_EQ(code(sphere, options), "option.range");
    options = {};
    options.sweeps = 0;
    EXPECT_EQ(code(sphere, options), "option.range");
}

}  // namespace fair_surface_test
}  // namespace batten
