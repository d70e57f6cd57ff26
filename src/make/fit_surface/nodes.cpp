#include "make/fit_surface/nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit_surface/grid_lines.hpp"
#include "make/fit_surface/mixed_noise.hpp"
#include "num/lanes.hpp"

namespace batten::surface_fitting {
namespace {

void require_axis(std::span<const double> axis, std::size_t size, const char* name) {
    if (axis.size() != size) {
        throw Error("fit-surface.sizes", name, std::to_string(axis.size()),
                    "the grid has " + std::to_string(size) + " lines in this direction");
    }
    require_lines(axis, name);
}

/// Errors that are a product are used as one: the full grid then needs no iteration.
bool is_product(const SurfaceSamples& given) {
    constexpr double rounding = 1e-12;
    const std::size_t ny = given.y.size();
    for (std::size_t r = 0; r < given.x.size(); ++r) {
        for (std::size_t s = 0; s < ny; ++s) {
            const double sigma = given.sigma[r * ny + s];
            if (!std::isfinite(sigma)) return false;
            const double product =
                given.sigma[r * ny] * (given.sigma[s] / given.sigma[0]);
            if (std::fabs(sigma - product) > rounding * sigma) return false;
        }
    }
    return true;
}

/// One factor a node where nodes are missing, weightless, or have errors of their own.
void take_cells(Nodes& nodes, const SurfaceSamples& given, bool has_own_errors) {
    const std::size_t ny = nodes.y.size();
    nodes.cell_factor_sq.assign(nodes.z.size(), 1.0);
    nodes.filled.assign(nodes.z.begin(), nodes.z.end());
    for (std::size_t r = 0; r < nodes.x.size(); ++r) {
        for (std::size_t s = 0; s < ny; ++s) {
            double& factor = nodes.cell_factor_sq[r * ny + s];
            if (has_own_errors) {
                const double weight =
                    1 / (given.sigma[r * ny + s] * nodes.x_weight[r] * nodes.y_weight[s]);
                factor = weight * weight;
            }
            if (!given.z.has(r, s)) factor = 0;
            if (factor == 0) nodes.filled[r * ny + s] = 0;
            nodes.count += factor > 0;
        }
    }
    nodes.z = nodes.filled;
    nodes.missing = nodes.z.size() - nodes.count;
}

/// Of the nodes that are there. Those that are no numbers are refused later: 0 where there are any.
double largest_height(const GridView& z) {
    const std::span<const double> values = z.values();
    std::array<double, num::lanes> lanes{};
    const auto take = [](double& largest, double height) {
        const double size = std::fabs(height);
        largest = size > largest ? size : largest;
    };
    std::size_t k = 0;
    for (; !z.has_mask() && k + num::lanes <= values.size(); k += num::lanes) {
        for (std::size_t l = 0; l < num::lanes; ++l) take(lanes[l], values[k + l]);
    }
    for (; k < values.size(); ++k) {
        if (z.has(k / z.nv(), k % z.nv())) take(lanes[0], values[k]);
    }
    const double largest = *std::max_element(lanes.begin(), lanes.end());
    return std::isfinite(largest) ? largest : 0;
}

/// The geometric mean of the errors, to be the common one of the preconditioner: the nearest power
/// of two, so that scaling stays exact.
double typical_sigma(std::span<const double> sigma) {
    double sum = 0, count = 0;
    for (const double s : sigma) {
        if (!std::isfinite(s)) continue;
        sum += std::log2(s);
        ++count;
    }
    return count > 0 ? std::exp2(std::round(sum / count)) : 1;
}

std::vector<double> used(const Nodes& nodes, bool by_x) {
    const std::span<const double> axis = by_x ? nodes.x : nodes.y;
    if (nodes.is_full()) return {axis.begin(), axis.end()};
    std::vector<double> result;
    const std::size_t ny = nodes.y.size();
    for (std::size_t i = 0; i < axis.size(); ++i) {
        const std::size_t others = by_x ? ny : nodes.x.size();
        bool is_used = false;
        for (std::size_t k = 0; k < others && !is_used; ++k) {
            is_used = nodes.cell_factor_sq[by_x ? i * ny + k : k * ny + i] > 0;
        }
        if (is_used) result.push_back(axis[i]);
    }
    return result;
}

}  // namespace

void require_finite_heights(const Nodes& nodes) {
    require_finite_heights(nodes.z, nodes.y.size());
}

bool Nodes::is_mask_only() const {
    return std::all_of(cell_factor_sq.begin(), cell_factor_sq.end(),
                       [](double f) { return f == 0 || f == 1; });
}

Interval Nodes::heights() const {
    if (stored) return stored->heights();
    Interval range = no_heights;
    for (std::size_t k = 0; k < z.size(); ++k) {
        if (cell_factor_sq[k] > 0) widen(range, z[k]);
    }
    return range;
}

void Nodes::for_masked_rows(const TakeMaskedRows& take) const {
    if (!stored) return take({0, z, cell_factor_sq});
    std::vector<double> heights, factors;
    stored->read([&](std::size_t first, std::span<const double> rows) {
        heights.assign(rows.begin(), rows.end());
        factors.assign(rows.size(), 1.0);
        for (std::size_t k = 0; k < heights.size(); ++k) {
            if (std::isnan(heights[k])) heights[k] = factors[k] = 0;
        }
        take({first, heights, factors});
    });
}

std::vector<double> Nodes::used_x() const {
    return stored && !is_full() ? stored->used_x() : used(*this, true);
}

std::vector<double> Nodes::used_y() const {
    return stored && !is_full() ? stored->used_y() : used(*this, false);
}

Nodes prepared_nodes(const SurfaceSamples& given, const FitSurfaceOptions& options) {
    require_axis(given.x, given.z.nu(), "x");
    require_axis(given.y, given.z.nv(), "y");
    const std::size_t size = given.x.size() * given.y.size();
    require_errors(given.x_sigma, given.x.size(), "x_sigma");
    require_errors(given.y_sigma, given.y.size(), "y_sigma");
    require_errors(given.sigma, size, "sigma");

    Nodes nodes;
    nodes.x = given.x;
    nodes.y = given.y;
    nodes.z = given.z.values();
    nodes.x_weight = weights_of(given.x_sigma, given.x.size());
    nodes.y_weight = weights_of(given.y_sigma, given.y.size());
    bool has_own_errors = false;
    nodes.sigma_known = true;
    nodes.source = SigmaSource::column;
    double common = 1, largest = 0;
    if (!given.sigma.empty()) {
        has_own_errors = !is_product(given);
        if (has_own_errors) {
            common = typical_sigma(given.sigma);
        } else {
            for (std::size_t r = 0; r < given.x.size(); ++r) {
                nodes.x_weight[r] = 1 / given.sigma[r * given.y.size()];
            }
            for (std::size_t s = 0; s < given.y.size(); ++s) {
                nodes.y_weight[s] = given.sigma[0] / given.sigma[s];
            }
        }
    } else if (given.x_sigma.empty() && given.y_sigma.empty()) {
        nodes.source = options.sigma ? SigmaSource::number : SigmaSource::estimated;
        nodes.sigma_known = options.sigma.has_value();
        if (!options.sigma) largest = largest_height(given.z);
        common = options.sigma ? *options.sigma : usable_noise(mixed_noise(given), largest);
        nodes.sigma = common;
    }
    for (double& weight : nodes.x_weight) weight /= common;
    bool has_holes = false;
    for (std::size_t r = 0; given.z.has_mask() && r < given.x.size() && !has_holes; ++r) {
        for (std::size_t s = 0; s < given.y.size() && !has_holes; ++s) {
            has_holes = !given.z.has(r, s);
        }
    }
    nodes.count = size;
    if (has_holes || has_own_errors) {
        nodes.count = 0;
        take_cells(nodes, given, has_own_errors);
    }
    if (!nodes.sigma_known) {
        const double accuracy = nodes.is_full() ? direct_accuracy : iterated_accuracy;
        nodes.least_delta2 = unavoidable_delta2(nodes.count, accuracy, largest, common);
    }
    if (nodes.count == 0) {
        throw Error("fit.too-few", "grid", "0 nodes", "at least one node must have a height");
    }
    return nodes;
}

}  // namespace batten::surface_fitting
