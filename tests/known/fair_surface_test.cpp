#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/make/fair_surface.hpp"
#include "errors.hpp"
#include "numpy_random.hpp"

namespace batten {
namespace fair_surface_test {

constexpr std::size_t n = 33;
constexpr double h = 0.0375;

enum class Kind { sphere, cylinder, ruled };

Grid surface(Kind kind) {
    Grid grid(n, n, 3);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const double u = (static_cast<double>(i) - 16) * h;
            const double v = (static_cast<double>(j) - 16) * h;
            grid(i, j, 0) = kind == Kind::cylinder ? std::sin(u) : u;
            grid(i, j, 1) = v;
            grid(i, j, 2) = kind == Kind::cylinder ? std::cos(u)
                            : kind == Kind::sphere ? std::sqrt(1.5 - u * u - v * v)
                                                   : u * v + 0.2 * std::sin(u) * (1 - v);
        }
    }
    return grid;
}

Grid with_noise(const Grid& exact, double sigma, unsigned seed) {
    Grid noisy = exact;
    testing::NumpyRandom random(seed);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const bool is_border = i == 0 || j == 0 || i + 1 == n || j + 1 == n;
            for (int k = 0; k < 3; ++k) noisy(i, j, k) += is_border ? 0 : sigma * random.normal();
        }
    }
    return noisy;
}

/// The rms distance across the surface, by the exact one's normals.
double error_of(const Grid& grid, const Grid& exact) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < n; ++i) {
        for (std::size_t j = 1; j + 1 < n; ++j) {
            double u[3], v[3], d[3];
            for (int k = 0; k < 3; ++k) {
                u[k] = exact(i + 1, j, k) - exact(i - 1, j, k);
                v[k] = exact(i, j + 1, k) - exact(i, j - 1, k);
                d[k] = grid(i, j, k) - exact(i, j, k);
            }
            const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2],
                         z = u[0] * v[1] - u[1] * v[0];
            const double off = (x * d[0] + y * d[1] + z * d[2]) / std::hypot(x, y, z);
            sum += off * off;
        }
    }
    return std::sqrt(sum / ((n - 2) * (n - 2)));
}

double curvature_error(const Grid& grid, const Grid& exact) {
    double sum = 0;
    for (std::size_t i = 2; i + 2 < n; ++i) {
        for (std::size_t j = 2; j + 2 < n; ++j) {
            const double e = gaussian_curvature(grid, i, j) - gaussian_curvature(exact, i, j);
            sum += e * e;
        }
    }
    return std::sqrt(sum / ((n - 4) * (n - 4)));
}

TEST(FairSurface, TakesMostOfTheNoiseAway) {
    for (const Kind kind : {Kind::sphere, Kind::cylinder, Kind::ruled}) {
        const Grid exact = surface(kind), noisy = with_noise(exact, 2e-3, 1);
        const SurfaceFairing made = fair_surface(noisy, {});
        EXPECT_LT(error_of(made.grid, exact), error_of(noisy, exact) / 7);
        EXPECT_GT(curvature_error(noisy, exact), 10);
        EXPECT_LT(curvature_error(made.grid, exact), 0.04);
        EXPECT_NEAR(made.report.sigma, 2e-3, 2e-4);
    }
}

TEST(FairSurface, KeepsTheBorderAsAskedAndScalesExactly) {
    const Grid noisy = with_noise(surface(Kind::sphere), 1e-3, 2);
    Grid large = noisy;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            for (int k = 0; k < 3; ++k) large(i, j, k) *= 256;
        }
    }
    for (const Border border : {Border::g0, Border::g1, Border::g2}) {
        FairSurfaceOptions options;
        options.border = border;
        const Grid fair = fair_surface(noisy, options).grid, big = fair_surface(large, options).grid;
        const std::size_t held = 1 + static_cast<std::size_t>(border);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                const bool is_held = i < held || j < held || i + held >= n || j + held >= n;
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
    EXPECT_EQ(code(Grid(9, 9, 1)), "grid.dimension");
    EXPECT_EQ(code(Grid(6, 9, 3)), "grid.too-small");
    Grid holed = surface(Kind::sphere);
    holed.drop(4, 5);
    EXPECT_EQ(code(holed), "grid.holes");
    Grid broken = surface(Kind::sphere);
    broken(3, 3, 1) = std::nan("");
    EXPECT_EQ(code(broken), "points.not-finite");
    FairSurfaceOptions options;
    options.sigma = -1;
    EXPECT_EQ(code(surface(Kind::sphere), options), "option.range");
}

}  // namespace fair_surface_test
}  // namespace batten
