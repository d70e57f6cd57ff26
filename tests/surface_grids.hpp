/// Grids of points on surfaces whose curvatures are known, with noise, and how far another is off.
#pragma once

#include <array>
#include <cmath>
#include <functional>

#include "batten/make/fair_surface.hpp"
#include "numpy_random.hpp"

namespace batten::testing {

constexpr std::size_t lines = 33;
constexpr double line_step = 0.0375;

enum class SurfaceKind { sphere, cylinder, pseudosphere, ruled, saddle };

inline std::array<double, 3> surface_point(SurfaceKind kind, double u, double v) {
    switch (kind) {
        case SurfaceKind::sphere:
            return {std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
        case SurfaceKind::cylinder: return {std::sin(u), v, std::cos(u)};
        case SurfaceKind::pseudosphere: {
            const double t = v + 1.2;
            return {std::cos(u) / std::cosh(t), std::sin(u) / std::cosh(t), t - std::tanh(t)};
        }
        case SurfaceKind::ruled:  // Coons patch of two translated cubics and two straight lines
            return {u + 0.3 * v, v, 0.5 * u * u + 0.1 * u * u * u + 0.2 * v};
        case SurfaceKind::saddle: return {u, v, u * v + 0.2 * std::sin(u) * (1 - v)};
    }
    return {};
}

/// At u and v of `at(i)`, i from -16 to 16.
inline Grid surface_grid(SurfaceKind kind, const std::function<double(double)>& at) {
    Grid grid(lines, lines, 3);
    for (std::size_t i = 0; i < lines; ++i) {
        for (std::size_t j = 0; j < lines; ++j) {
            const auto p = surface_point(kind, at(double(i) - 16), at(double(j) - 16));
            for (int k = 0; k < 3; ++k) grid(i, j, k) = p[static_cast<std::size_t>(k)];
        }
    }
    return grid;
}

inline Grid surface_grid(SurfaceKind kind) {
    return surface_grid(kind, [](double i) { return i * line_step; });
}

/// Normal noise on all nodes but the border's.
inline Grid with_noise(const Grid& exact, double sigma, unsigned seed) {
    Grid noisy = exact;
    NumpyRandom random(seed);
    for (std::size_t i = 1; i + 1 < exact.nu(); ++i) {
        for (std::size_t j = 1; j + 1 < exact.nv(); ++j) {
            for (int k = 0; k < 3; ++k) noisy(i, j, k) += sigma * random.normal();
        }
    }
    return noisy;
}

/// The rms distance across the surface, by the exact one's normals.
inline double distance_across(const Grid& grid, const Grid& exact) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < exact.nu(); ++i) {
        for (std::size_t j = 1; j + 1 < exact.nv(); ++j) {
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
    return std::sqrt(sum / double((exact.nu() - 2) * (exact.nv() - 2)));
}

/// The rms difference of a curvature two and more lines inside.
template <class Curvature>
double bend_error(const Grid& grid, const Grid& exact, Curvature curvature) {
    double sum = 0;
    for (std::size_t i = 2; i + 2 < exact.nu(); ++i) {
        for (std::size_t j = 2; j + 2 < exact.nv(); ++j) {
            const double e = curvature(grid, i, j) - curvature(exact, i, j);
            sum += e * e;
        }
    }
    return std::sqrt(sum / double((exact.nu() - 4) * (exact.nv() - 4)));
}

}  // namespace batten::testing
