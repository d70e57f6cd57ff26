#include "make/fit_surface/grid_lines.hpp"

#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::surface_fitting {

void require_rising(std::span<const double> lines, const char* name) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string place = std::string(name) + ' ' + std::to_string(i);
        if (!std::isfinite(lines[i])) {
            throw Error("points.not-finite", place, format_number(lines[i]),
                        "coordinates must be finite", {i});
        }
        if (i > 0 && !(lines[i - 1] < lines[i])) {
            throw Error("fit-surface.axis", place, format_number(lines[i]),
                        "the lines of a grid must rise");
        }
    }
}

void require_lines(std::span<const double> lines, const char* name) {
    if (lines.size() < 2) {
        throw Error("fit-surface.axis", name, std::to_string(lines.size()),
                    "a grid has at least two lines in each direction");
    }
    require_rising(lines, name);
}

void require_errors(std::span<const double> sigma, std::size_t count, const char* name) {
    if (sigma.empty()) return;
    if (sigma.size() != count) {
        throw Error("fit-surface.sizes", name, std::to_string(sigma.size()),
                    std::to_string(count) + " errors are needed");
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (sigma[i] > 0) continue;
        throw Error("fit.sigma", std::string(name) + ' ' + std::to_string(i),
                    format_number(sigma[i]), "errors must be above 0");
    }
}

void refuse_height(std::size_t row, std::size_t column, double z) {
    throw Error("points.not-finite",
                "node " + std::to_string(row) + ',' + std::to_string(column), format_number(z),
                "heights must be finite");
}

void require_finite_heights(std::span<const double> z, std::size_t columns, std::size_t first) {
    for (std::size_t k = 0; k < z.size(); ++k) {
        if (!std::isfinite(z[k])) refuse_height(first + k / columns, k % columns, z[k]);
    }
}

std::vector<double> weights_of(std::span<const double> sigma, std::size_t count) {
    std::vector<double> weights(count, 1.0);
    for (std::size_t i = 0; i < sigma.size(); ++i) weights[i] = 1 / sigma[i];
    return weights;
}

}  // namespace batten::surface_fitting
