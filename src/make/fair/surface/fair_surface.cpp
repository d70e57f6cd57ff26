#include "batten/make/fair_surface.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/measure/surface.hpp"
#include "make/fair/surface/bend.hpp"
#include "make/fair/surface/evenness.hpp"
#include "make/fair/surface/filter.hpp"

namespace batten {
namespace {

constexpr std::size_t fewest_lines = 7;
/// Of the mean distance: fourth differences divide by the fourth power.
constexpr double closest_lines = 1e-5;
/// Of the extent: the filter rests where no node moves further, rounding among the moves.
constexpr double filter_rest = 1e-12;

void require_nodes(const GridView& grid) {
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
}

void require_options(const FairSurfaceOptions& options) {
    if (options.sigma && !(*options.sigma > 0 && std::isfinite(*options.sigma))) {
        throw Error("option.range", "sigma", format_number(*options.sigma), "must be above 0");
    }
    const double weight = options.weight_curvature.value_or(0);
    if (!(weight >= 0 && std::isfinite(weight))) {
        throw Error("option.range", "weight_curvature", format_number(weight),
                    "must not be below 0");
    }
    if (options.sweeps < 1) {
        throw Error("option.range", "sweeps", std::to_string(options.sweeps), "must be above 0");
    }
}

void require_grid(const GridView& grid, const FairSurfaceOptions& options) {
    if (grid.dim() != 3) {
        throw Error("grid.dimension", "grid", std::to_string(grid.dim()) + " values a node",
                    "nodes are points in space: 3 values");
    }
    if (grid.nu() < fewest_lines || grid.nv() < fewest_lines) {
        throw Error("grid.too-small", "grid",
                    std::to_string(grid.nu()) + " x " + std::to_string(grid.nv()),
                    "needs at least 7 x 7 nodes");
    }
    require_nodes(grid);
    require_options(options);
}

void require_apart(const std::vector<double>& knots, const char* which) {
    const double least = closest_lines * knots.back() / static_cast<double>(knots.size() - 1);
    for (std::size_t i = 1; i < knots.size(); ++i) {
        if (knots[i] - knots[i - 1] > least) continue;
        throw Error("grid.repeated", std::string(which) + " " + std::to_string(i),
                    "on the one before it",
                    "neighbouring lines of nodes must be apart, by 1e-5 of the mean at least");
    }
}

/// The power of two that makes the extent at least 1 and below 2.
double unit_of(const GridView& grid) {
    double extent = 0;
    for (int k = 0; k < 3; ++k) {
        double low = grid(0, 0, k), high = low;
        for (std::size_t i = 0; i < grid.nu(); ++i) {
            for (std::size_t j = 0; j < grid.nv(); ++j) {
                low = std::fmin(low, grid(i, j, k));
                high = std::fmax(high, grid(i, j, k));
            }
        }
        extent = std::fmax(extent, high - low);
    }
    return extent > 0 ? std::ldexp(1.0, std::ilogb(extent)) : 1;
}

fairing::Differences chord_differences(const GridView& g, std::array<std::size_t, 2> before,
                              std::array<std::size_t, 2> at, std::array<std::size_t, 2> after) {
    const auto chord = [&](std::array<std::size_t, 2> p, std::array<std::size_t, 2> q) {
        return std::hypot(g(p[0], p[1], 0) - g(q[0], q[1], 0), g(p[0], p[1], 1) - g(q[0], q[1], 1),
                          g(p[0], p[1], 2) - g(q[0], q[1], 2));
    };
    return fairing::differences(chord(before, at), chord(at, after));
}

/// The curvatures at an inner node, by chords; 0 where the differences are parallel.
SurfaceBend bend_at(const GridView& g, std::size_t i, std::size_t j) {
    fairing::Planes around;
    for (fairing::Plane& plane : around.at) plane.resize(3, 3);
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            const std::size_t p = i + a - 1, q = j + b - 1;
            around.set(a, b, {g(p, q, 0) - g(i, j, 0), g(p, q, 1) - g(i, j, 1),
                              g(p, q, 2) - g(i, j, 2)});
        }
    }
    const auto u = chord_differences(g, {i - 1, j}, {i, j}, {i + 1, j});
    const auto v = chord_differences(g, {i, j - 1}, {i, j}, {i, j + 1});
    return surface_bend(fairing::node_jet(around, u, v, 1, 1)).value_or(SurfaceBend{});
}

CurvatureSpread spread_of(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double size = std::fmax(std::fabs(*least), std::fabs(*most));
    double sum = 0;  // over the largest: squares may be beyond a double
    for (const double value : values) sum += size > 0 ? value / size * (value / size) : 0;
    return {*least, *most, size * std::sqrt(sum / static_cast<double>(values.size()))};
}

void tell_curvatures(const Grid& grid, FairSurfaceReport& report) {
    std::vector<double> gaussian, mean;
    for (std::size_t i = 1; i + 1 < grid.nu(); ++i) {
        for (std::size_t j = 1; j + 1 < grid.nv(); ++j) {
            const SurfaceBend bend = bend_at(grid, i, j);
            gaussian.push_back(bend.gaussian);
            mean.push_back(bend.mean);
        }
    }
    report.gaussian_curvature = spread_of(gaussian);
    report.mean_curvature = spread_of(mean);
}

/// Moves the nodes to where they are in `planes`; those that stay keep their bits.
void put_back(const fairing::Planes& planes, double unit, const GridView& data,
              SurfaceFairing& result) {
    double sum = 0, most = 0, count = 0;
    for (std::size_t i = 0; i < data.nu(); ++i) {
        for (std::size_t j = 0; j < data.nv(); ++j) {
            const space::Vector p = planes(i, j);
            double moved_sq = 0;
            for (int k = 0; k < 3; ++k) {
                const double before = (data(i, j, k) - data(0, 0, k)) / unit;
                const double d = p[static_cast<std::size_t>(k)] - before;
                result.grid(i, j, k) = data(i, j, k) + d * unit;
                moved_sq += d * d;
            }
            sum += moved_sq;
            most = std::fmax(most, moved_sq);
            count += 1;
        }
    }
    result.report.rms_displacement = std::sqrt(sum / count) * unit;
    result.report.max_displacement = std::sqrt(most) * unit;
}

/// A smoothed and evened grid, in working units; what is to say goes into the report.
fairing::Planes balanced(const fairing::Planes& data, const fairing::Knots& knots,
                         const FairSurfaceOptions& options, double unit,
                         FairSurfaceReport& report) {
    const std::size_t held = 1 + static_cast<std::size_t>(options.border);
    const auto u = fairing::axis_of(knots.u, held), v = fairing::axis_of(knots.v, held);
    std::optional<double> sigma;
    if (options.sigma) sigma = *options.sigma / unit;
    const auto smooth = fairing::smoothed(data, u, v, sigma);
    report.sigma = options.sigma.value_or(std::sqrt(smooth.sigma_sq) * unit);
    if (!options.sigma) report.notes.push_back("the smoothing is found by cross-validation");
    auto even = fairing::evened({data, smooth, knots, u, v, options.target,
                                 options.weight_curvature});
    report.weight_curvature = even.weight;
    report.steps = even.steps;
    if (!even.converged) report.status = Status::not_converged;
    return std::move(even.planes);
}

fairing::Planes swept(const fairing::Planes& data, const FairSurfaceOptions& options,
                      FairSurfaceReport& report) {
    const std::size_t held = 1 + static_cast<std::size_t>(options.border);
    auto made = fairing::filtered(data, {held, options.sweeps, options.root, options.target});
    report.steps = made.sweeps;
    if (options.sigma) report.sigma = options.sigma;
    if (made.burst) {
        report.notes.push_back("unstable: sweep " + std::to_string(made.sweeps) +
                               " would move nodes further than the grid is wide");
    } else if (made.rootless > 0) {
        report.notes.push_back("unstable: no step exists for " + std::to_string(made.rootless) +
                               " nodes of the last sweep");
    }
    const bool rests = made.last_move <= filter_rest && made.rootless == 0;
    if (!rests) report.status = Status::not_converged;
    return std::move(made.planes);
}

}  // namespace

double gaussian_curvature(const GridView& grid, std::size_t i, std::size_t j) {
    return bend_at(grid, i, j).gaussian;
}

double mean_curvature(const GridView& grid, std::size_t i, std::size_t j) {
    return bend_at(grid, i, j).mean;
}

SurfaceFairing fair_surface(const GridView& grid, const FairSurfaceOptions& options) {
    require_grid(grid, options);
    const double unit = unit_of(grid);
    const fairing::Planes data = fairing::planes_of(grid, unit);
    const fairing::Knots knots = fairing::knots_of(data);
    require_apart(knots.u, "line u");
    require_apart(knots.v, "line v");
    SurfaceFairing result{Grid(grid.nu(), grid.nv(), 3), {}};
    const fairing::Planes made = options.engine == SurfaceEngine::filter
                                     ? swept(data, options, result.report)
                                     : balanced(data, knots, options, unit, result.report);
    put_back(made, unit, grid, result);
    tell_curvatures(result.grid, result.report);
    return result;
}

}  // namespace batten
