#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "batten/make/fit_surface.hpp"
#include "fit_samples.hpp"
#include "shared.hpp"

/// Data for the tests of surfaces.
namespace batten::testing {

/// An owned grid of heights.
struct SurfaceTable {
    std::vector<double> x, y;
    Grid z{0, 0};
    std::vector<double> sigma = {};

    SurfaceSamples view() const { return {x, y, z, {}, {}, sigma}; }
};

inline std::vector<double> distinct(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

/// `../shared/reference/fitting/NAME.csv`, rows x, y, f with y fastest.
inline SurfaceTable surface_table(std::string_view name) {
    const CsvTable csv = shared_csv(std::string("reference/fitting/").append(name).append(".csv"));
    SurfaceTable table{distinct(csv.column("x")), distinct(csv.column("y"))};
    table.z = Grid(table.x.size(), table.y.size());
    const std::vector<double> f = csv.column("f");
    for (std::size_t i = 0; i < table.x.size(); ++i) {
        for (std::size_t j = 0; j < table.y.size(); ++j) table.z(i, j) = f[i * table.y.size() + j];
    }
    return table;
}

/// Heights of a function on an even grid of [0, 1] x [0, 1], with normal errors.
template <class F>
SurfaceTable surface_of(F f, std::size_t m, std::size_t n, double sigma = 0,
                        std::uint64_t seed = 1) {
    Noise noise(seed);
    SurfaceTable table{even_places({0, 1}, m), even_places({0, 1}, n)};
    table.z = Grid(m, n);
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            table.z(i, j) = f(table.x[i], table.y[j]) + (sigma > 0 ? sigma * noise.normal() : 0);
        }
    }
    return table;
}

}  // namespace batten::testing
