#pragma once

#include <limits>

#include "batten/make/fit_surface_chunks.hpp"
#include "surface_samples.hpp"

/// Grids that come in blocks of rows.
namespace batten::testing {

/// Waves and a hill about as wide as a tenth.
inline double land(double x, double y) {
    const double dx = x - 0.3, dy = y - 0.6;
    return std::sin(5 * x) * std::cos(4 * y) + std::exp(-(dx * dx + dy * dy) / 0.005);
}

/// Borrows the table; missing nodes are NaN.
inline SurfaceStream stream_of(const SurfaceTable& table, std::size_t rows_at_once = 0) {
    const auto read = [&table](std::size_t first, std::span<double> z) {
        const std::size_t n = table.y.size();
        for (std::size_t k = 0; k < z.size(); ++k) {
            const std::size_t r = first + k / n, s = k % n;
            z[k] = table.z.has(r, s) ? table.z(r, s) : std::numeric_limits<double>::quiet_NaN();
        }
    };
    return {table.x, table.y, read, {}, {}, rows_at_once};
}

/// Errors of rows and of columns, about 0.02 in all.
struct UnevenErrors {
    explicit UnevenErrors(const SurfaceTable& table) {
        for (std::size_t i = 0; i < table.x.size(); ++i) {
            x.push_back(0.02 * (1.5 + std::sin(0.1 * static_cast<double>(i))));
        }
        for (std::size_t j = 0; j < table.y.size(); ++j) {
            y.push_back(1.5 + std::cos(0.2 * static_cast<double>(j)));
        }
    }
    template <class Samples>
    Samples of(Samples samples) const {
        samples.x_sigma = x;
        samples.y_sigma = y;
        return samples;
    }

    std::vector<double> x, y;
};

/// Of the strips in x.
inline double narrowest_strip(const FitSurfaceReport& report) {
    double narrowest = report.breaks_x[1] - report.breaks_x[0];
    for (std::size_t i = 2; i < report.breaks_x.size(); ++i) {
        narrowest = std::min(narrowest, report.breaks_x[i] - report.breaks_x[i - 1]);
    }
    return narrowest;
}

}  // namespace batten::testing
