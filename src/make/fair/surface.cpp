#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/fair_surface.hpp"
#include "batten/measure/surface.hpp"
#include "make/fair/smooth.hpp"

namespace batten {
namespace {

using fairing::Track;

constexpr std::size_t fewest = 7;

void require_grid(const GridView& grid, const FairSurfaceOptions& options) {
    if (grid.dim() != 3) {
        throw Error("grid.dimension", "grid", std::to_string(grid.dim()) + " values a node",
                    "nodes are points in space: 3 values");
    }
    if (grid.nu() < fewest || grid.nv() < fewest) {
        throw Error("grid.too-small", "grid",
                    std::to_string(grid.nu()) + " x " + std::to_string(grid.nv()),
                    "needs at least 7 x 7 nodes");
    }
    for (std::size_t i = 0; i < grid.nu(); ++i) {
        for (std::size_t j = 0; j < grid.nv(); ++j) {
            const std::string place = "node " + std::to_string(i) + "," + std::to_string(j);
            if (!grid.has(i, j)) {
                throw Error("grid.holes", place, "missing", "every node must be there");
            }
            for (int k = 0; k < 3; ++k) {
                if (std::isfinite(grid(i, j, k))) continue;
                throw Error("points.not-finite", place, format_number(grid(i, j, k)),
                            "coordinates must be finite");
            }
        }
    }
    if (options.sigma && !(*options.sigma > 0 && std::isfinite(*options.sigma))) {
        throw Error("option.range", "sigma", format_number(*options.sigma), "must be above 0");
    }
}

/// A line of nodes: along u at index `across`, or along v.
enum class Along { u, v };

void smooth_line(Grid& grid, Along along, std::size_t across, double mu, std::size_t held) {
    const std::size_t n = along == Along::u ? grid.nu() : grid.nv();
    const auto node = [&](std::size_t i, int k) -> double& {
        return along == Along::u ? grid(i, across, k) : grid(across, i, k);
    };
    Track xy{std::vector<double>(n), std::vector<double>(n), false}, zz = xy;
    for (std::size_t i = 0; i < n; ++i) {
        xy.x[i] = node(i, 0), xy.y[i] = node(i, 1);
        zz.x[i] = node(i, 2);
    }
    xy = fairing::smoothed(xy, mu, held);
    zz = fairing::smoothed(zz, mu, held);
    for (std::size_t i = held; i + held < n; ++i) {
        node(i, 0) = xy.x[i], node(i, 1) = xy.y[i], node(i, 2) = zz.x[i];
    }
}

Grid smoothed(const GridView& data, double mu, std::size_t held) {
    Grid grid(data.nu(), data.nv(), 3);
    for (std::size_t i = 0; i < data.nu(); ++i) {
        for (std::size_t j = 0; j < data.nv(); ++j) {
            for (int k = 0; k < 3; ++k) grid(i, j, k) = data(i, j, k);
        }
    }
    for (std::size_t j = held; j + held < data.nv(); ++j) smooth_line(grid, Along::u, j, mu, held);
    for (std::size_t i = held; i + held < data.nu(); ++i) smooth_line(grid, Along::v, i, mu, held);
    return grid;
}

/// The share of its data that a line of n nodes keeps: the mean of the smoother's diagonal.
double kept_share(std::size_t n, double mu, std::size_t held) {
    double sum = 0;
    for (std::size_t i = held; i + held < n; i += 2) {
        Track unit{std::vector<double>(n), std::vector<double>(n), false};
        unit.x[i] = 1;
        if (i + 1 + held < n) unit.y[i + 1] = 1;
        const Track smooth = fairing::smoothed(unit, mu, held);
        sum += smooth.x[i] + (i + 1 + held < n ? smooth.y[i + 1] : 0);
    }
    return sum / static_cast<double>(n - 2 * held);
}

/// Mean squared displacement of one coordinate of the nodes that may move.
double displacement_sq(const GridView& a, const GridView& b, std::size_t held) {
    double sum = 0, count = 0;
    for (std::size_t i = held; i + held < a.nu(); ++i) {
        for (std::size_t j = held; j + held < a.nv(); ++j) {
            for (int k = 0; k < 3; ++k) {
                const double d = a(i, j, k) - b(i, j, k);
                sum += d * d;
                count += 1;
            }
        }
    }
    return sum / count;
}

/// The grid of least error to be expected.
Grid best_smoothed(const GridView& data, const FairSurfaceOptions& options, std::size_t held) {
    Grid best = smoothed(data, 0, held);
    double least = std::numeric_limits<double>::infinity();
    const double n = static_cast<double>(std::max(data.nu(), data.nv()));
    double rising = 0;
    for (double mu = 0.01; mu <= std::pow(n / 3, 8); mu *= std::sqrt(10.0)) {
        Grid grid = smoothed(data, mu, held);
        const double moved_sq = displacement_sq(grid, data, held);
        const double left = 1 - kept_share(data.nu(), mu, held) * kept_share(data.nv(), mu, held);
        // Mallows' criterion where the noise is known, cross-validation where it is not.
        const double error = options.sigma
                                 ? moved_sq + 2 * *options.sigma * *options.sigma * (1 - left)
                                 : moved_sq / (left * left);
        if (error < least) {
            least = error;
            best = std::move(grid);
            rising = 0;
        } else if (++rising == 4) {
            break;
        }
    }
    return best;
}

}  // namespace

double gaussian_curvature(const GridView& g, std::size_t i, std::size_t j) {
    SurfaceJet jet;
    for (int k = 0; k < 3; ++k) {
        const std::size_t x = static_cast<std::size_t>(k);
        jet.u[x] = 0.5 * (g(i + 1, j, k) - g(i - 1, j, k));
        jet.v[x] = 0.5 * (g(i, j + 1, k) - g(i, j - 1, k));
        jet.uu[x] = g(i + 1, j, k) - 2 * g(i, j, k) + g(i - 1, j, k);
        jet.vv[x] = g(i, j + 1, k) - 2 * g(i, j, k) + g(i, j - 1, k);
        jet.uv[x] = 0.25 * (g(i + 1, j + 1, k) - g(i + 1, j - 1, k) - g(i - 1, j + 1, k) +
                            g(i - 1, j - 1, k));
    }
    const auto bend = surface_bend(jet);
    return bend ? bend->gaussian : 0;
}

SurfaceFairing fair_surface(const GridView& grid, const FairSurfaceOptions& options) {
    require_grid(grid, options);
    const std::size_t held = 1 + static_cast<std::size_t>(options.border);
    SurfaceFairing result{best_smoothed(grid, options, held), {}};
    FairSurfaceReport& report = result.report;
    const double moved_sq = displacement_sq(result.grid, grid, held);
    report.rms_displacement = std::sqrt(3 * moved_sq);
    report.sigma = options.sigma.value_or(std::sqrt(moved_sq));
    if (!options.sigma) report.notes.push_back("the smoothing is found by cross-validation");
    CurvatureSpread& spread = report.gaussian_curvature;
    spread = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0};
    double count = 0;
    for (std::size_t i = 1; i + 1 < grid.nu(); ++i) {
        for (std::size_t j = 1; j + 1 < grid.nv(); ++j) {
            const double k = gaussian_curvature(result.grid, i, j);
            spread.min = std::fmin(spread.min, k);
            spread.max = std::fmax(spread.max, k);
            spread.rms += k * k;
            count += 1;
        }
    }
    spread.rms = std::sqrt(spread.rms / count);
    return result;
}

}  // namespace batten
