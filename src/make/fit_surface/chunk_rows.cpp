#include "make/fit_surface/chunk_rows.hpp"

#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit_surface/grid_lines.hpp"

namespace batten::surface_fitting {
namespace {

void require_inside(std::span<const double> lines, Interval domain, const char* name) {
    for (const double line : lines) {
        if (domain.contains(line)) continue;
        throw Error("fit.outside", name, format_number(line), "must lie in the knots' domain");
    }
}

/// A height that is none spoils the sum; only then it is looked for.
bool is_all_finite(std::span<const double> z) {
    double lanes[8] = {};
    const std::size_t whole = z.size() / 8 * 8;
    for (std::size_t k = 0; k < whole; k += 8) {
        for (std::size_t l = 0; l < 8; ++l) lanes[l] += 0 * z[k + l];
    }
    for (std::size_t k = whole; k < z.size(); ++k) lanes[0] += 0 * z[k];
    double sum = 0;
    for (const double lane : lanes) sum += lane;
    return sum == 0;
}

}  // namespace

void require_finite_rows(std::span<const double> z, std::size_t columns, std::size_t first) {
    if (!is_all_finite(z)) require_finite_heights(z, columns, first);
}

bool has_holes(std::span<const double> z, std::size_t columns, std::size_t first) {
    if (is_all_finite(z)) return false;
    for (std::size_t k = 0; k < z.size(); ++k) {
        if (std::isinf(z[k])) refuse_height(first + k / columns, k % columns, z[k]);
    }
    return true;
}

void require_columns(const SurfaceColumns& columns, const BSplineBasis& y) {
    require_lines(columns.y, "y");
    require_errors(columns.y_sigma, columns.y.size(), "y_sigma");
    require_inside(columns.y, y.domain(), "y");
}

void require_rows(const SurfaceRows& rows, const SurfaceColumns& columns, const BSplineBasis& x,
                  double sigma) {
    require_rising(rows.x, "x");
    require_inside(rows.x, x.domain(), "x");
    require_errors(rows.x_sigma, rows.x.size(), "x_sigma");
    require_errors({&sigma, 1}, 1, "sigma");
    if (rows.z.size() != rows.x.size() * columns.y.size()) {
        throw Error("fit-surface.sizes", "z", std::to_string(rows.z.size()),
                    std::to_string(rows.x.size()) + " whole rows of " +
                        std::to_string(columns.y.size()) + " heights are needed");
    }
}

}  // namespace batten::surface_fitting
