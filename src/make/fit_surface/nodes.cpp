#include "make/fit_surface/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "num/rows.hpp"

namespace batten::surface_fitting {
namespace {

void require_axis(std::span<const double> axis, std::size_t size, const char* name) {
    if (axis.size() != size) {
        throw Error("fit-surface.sizes", name, std::to_string(axis.size()),
                    "the grid has " + std::to_string(size) + " lines in this direction");
    }
    if (axis.size() < 2) {
        throw Error("fit-surface.axis", name, std::to_string(axis.size()),
                    "a grid has at least two lines in each direction");
    }
    for (std::size_t i = 0; i < axis.size(); ++i) {
        const std::string place = std::string(name) + ' ' + std::to_string(i);
        if (!std::isfinite(axis[i])) {
            throw Error("points.not-finite", place, format_number(axis[i]),
                        "coordinates must be finite", {i});
        }
        if (i > 0 && !(axis[i - 1] < axis[i])) {
            throw Error("fit-surface.axis", place, format_number(axis[i]),
                        "the lines of a grid must rise");
        }
    }
}

void require_sigma(std::span<const double> sigma, std::size_t size, const char* name) {
    if (sigma.empty()) return;
    if (sigma.size() != size) {
        throw Error("fit-surface.sizes", name, std::to_string(sigma.size()),
                    std::to_string(size) + " errors are needed");
    }
    for (std::size_t i = 0; i < sigma.size(); ++i) {
        if (sigma[i] > 0) continue;
        throw Error("fit.sigma", std::string(name) + ' ' + std::to_string(i),
                    format_number(sigma[i]), "errors must be above 0");
    }
}

/// f(middle) against the line through its neighbours, over the norm of this functional.
std::array<double, 3> second_difference(std::span<const double> t, std::size_t i) {
    const double left = (t[i + 1] - t[i]) / (t[i + 1] - t[i - 1]);
    const double right = 1 - left;
    const double norm = std::sqrt(1 + left * left + right * right);
    return {-left / norm, 1 / norm, -right / norm};
}

/// The sum of the squares of the mixed second differences where all nine nodes are there, and how
/// many these are.
struct Differences {
    double sum_sq = 0;
    std::size_t count = 0;
};

Differences whole_differences(const SurfaceSamples& given) {
    Differences result;
    for (std::size_t r = 1; r + 1 < given.x.size(); ++r) {
        const std::array<double, 3> a = second_difference(given.x, r);
        for (std::size_t s = 1; s + 1 < given.y.size(); ++s) {
            const std::array<double, 3> b = second_difference(given.y, s);
            double value = 0;
            bool is_whole = true;
            for (std::size_t i = 0; i < 3; ++i) {
                for (std::size_t j = 0; j < 3; ++j) {
                    is_whole = is_whole && given.z.has(r + i - 1, s + j - 1);
                    value += a[i] * b[j] * given.z(r + i - 1, s + j - 1);
                }
            }
            if (!is_whole) continue;
            result.sum_sq += value * value;
            ++result.count;
        }
    }
    return result;
}

/// The same without missing nodes, row by row.
Differences differences_of_rows(const SurfaceSamples& given) {
    const std::size_t m = given.x.size(), n = given.y.size();
    Differences result;
    if (m < 3 || n < 3) return result;
    std::vector<std::array<double, 3>> b;
    for (std::size_t s = 1; s + 1 < n; ++s) b.push_back(second_difference(given.y, s));
    std::vector<double> across(n), values(n - 2);
    for (std::size_t r = 1; r + 1 < m; ++r) {
        std::fill(across.begin(), across.end(), 0.0);
        num::add_combination(second_difference(given.x, r),
                             given.z.values().subspan((r - 1) * n, 3 * n), across);
        for (std::size_t s = 0; s + 2 < n; ++s) {
            values[s] = b[s][0] * across[s] + b[s][1] * across[s + 1] + b[s][2] * across[s + 2];
        }
        result.sum_sq += num::sum_of_squares(values);
    }
    result.count = (m - 2) * (n - 2);
    return result;
}

/// Noise level from mixed second differences: blind to u(x) + v(y) and to bilinear parts.
/// Source: [Immerkaer1996], for uneven grids.
double noise_of(const SurfaceSamples& given) {
    const Differences d =
        given.z.has_mask() ? whole_differences(given) : differences_of_rows(given);
    return d.count == 0 ? 0 : std::sqrt(d.sum_sq / static_cast<double>(d.count));
}

std::vector<double> inverses(std::span<const double> sigma, std::size_t size) {
    std::vector<double> weights(size, 1.0);
    for (std::size_t i = 0; i < sigma.size(); ++i) weights[i] = 1 / sigma[i];
    return weights;
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
    for (std::size_t k = 0; k < nodes.z.size(); ++k) {
        if (std::isfinite(nodes.z[k])) continue;
        const std::size_t ny = nodes.y.size();
        throw Error("points.not-finite",
                    "node " + std::to_string(k / ny) + ',' + std::to_string(k % ny),
                    format_number(nodes.z[k]), "heights must be finite");
    }
}

std::vector<double> Nodes::used_x() const { return used(*this, true); }
std::vector<double> Nodes::used_y() const { return used(*this, false); }

Nodes prepared_nodes(const SurfaceSamples& given, const FitSurfaceOptions& options) {
    require_axis(given.x, given.z.nu(), "x");
    require_axis(given.y, given.z.nv(), "y");
    const std::size_t size = given.x.size() * given.y.size();
    require_sigma(given.x_sigma, given.x.size(), "x_sigma");
    require_sigma(given.y_sigma, given.y.size(), "y_sigma");
    require_sigma(given.sigma, size, "sigma");

    Nodes nodes;
    nodes.x = given.x;
    nodes.y = given.y;
    nodes.z = given.z.values();
    nodes.x_weight = inverses(given.x_sigma, given.x.size());
    nodes.y_weight = inverses(given.y_sigma, given.y.size());
    bool has_own_errors = false;
    nodes.sigma_known = true;
    nodes.source = SigmaSource::column;
    double common = 1;
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
        common = options.sigma ? *options.sigma : noise_of(given);
        if (!(common > 0)) common = 1;
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
    if (nodes.count == 0) {
        throw Error("fit.too-few", "grid", "0 nodes", "at least one node must have a height");
    }
    return nodes;
}

}  // namespace batten::surface_fitting
