#include "make/densify/windows.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::lagrange {
namespace {

double distance(std::span<const double> a, std::span<const double> b) {
    double norm = 0;
    for (std::size_t k = 0; k < a.size(); ++k) norm = std::hypot(norm, b[k] - a[k]);
    return norm;
}

void require_increasing(std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i]) || (i > 0 && !(values[i - 1] < values[i]))) {
            throw Error("lagrange.parameters-not-increasing", "parameter " + std::to_string(i),
                        format_number(values[i]), "parameters must be finite and rise strictly");
        }
    }
}

}  // namespace

Window Windows::placed(std::ptrdiff_t k, bool at_end, int lean) const {
    const auto start = [&](int m) { return k - (m - lean) / 2; };
    if (closed) return {start(degree), degree};
    const bool runs_out = start(degree) < 0 || start(degree) > last_start(degree);
    const int m = at_end || runs_out ? end_degree : degree;
    return {std::clamp<std::ptrdiff_t>(start(m), 0, last_start(m)), m};
}

Window Windows::of_cell(std::ptrdiff_t k) const {
    return placed(k, k == 0 || k + 1 == cells(), 1);
}

Window Windows::of_point(std::ptrdiff_t k) const {
    return placed(k, k == 0 || k + 1 == points, 0);
}

std::vector<double> cumulative(PointsView points, LagrangeParameter parameter, bool closed) {
    const std::size_t n = points.size();
    std::vector<double> sums(n + (closed ? 1 : 0));
    if (parameter == LagrangeParameter::index) {
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = static_cast<double>(i);
        return sums;
    }
    double longest = 0;
    for (std::size_t i = 1; i < sums.size(); ++i) {
        longest = std::max(longest, distance(points[i - 1], points[i % n]));
    }
    // Square roots of lengths in units of a power of two near the longest: so a figure 2^k as
    // large has the same parameters.
    const bool rooted = parameter == LagrangeParameter::centripetal;
    const double unit = longest > 0 ? std::ldexp(1.0, std::ilogb(longest)) : 1;
    for (std::size_t i = 1; i < sums.size(); ++i) {
        const double length = distance(points[i - 1], points[i % n]);
        sums[i] = sums[i - 1] + (rooted ? std::sqrt(length / unit) : length);
    }
    return sums;
}

std::vector<double> parameters_of(PointsView points, const DensifyOptions& options) {
    require_finite(points);
    require_distinct(points, options.closed);
    if (options.parameter_values.empty()) {
        std::vector<double> sums = cumulative(points, options.parameter, options.closed);
        require_increasing(sums);
        return sums;
    }
    const std::size_t wanted = points.size() + (options.closed ? 1 : 0);
    if (options.parameter_values.size() != wanted) {
        throw Error("lagrange.parameter-count", "parameter_values",
                    std::to_string(options.parameter_values.size()),
                    "one for each point is needed, closed one more: " + std::to_string(wanted));
    }
    require_increasing(options.parameter_values);
    return options.parameter_values;
}

Recipe recipe_of(std::span<const double> nodes, int cell) {
    const std::size_t start = static_cast<std::size_t>(cell);
    const double width = nodes[start + 1] - nodes[start];
    Recipe recipe;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (i == start || i == start + 1) continue;
        const std::size_t k = static_cast<std::size_t>(recipe.terms++);
        recipe.other[k] = static_cast<int>(i) - cell;
        recipe.place[k] = (nodes[i] - nodes[start]) / width;
    }
    const std::size_t terms = static_cast<std::size_t>(recipe.terms);
    for (std::size_t i = 0; i < terms; ++i) {
        const double x = recipe.place[i];
        // The power coefficients of prod over l of (s - x_l) / (x_i - x_l), over x_i (x_i - 1).
        std::array<double, highest_degree> product{1.0};
        double below = x * (x - 1);
        for (std::size_t l = 0, power = 0; l < terms; ++l) {
            if (l == i) continue;
            ++power;
            for (std::size_t j = power; j > 0; --j) {
                product[j] = product[j - 1] - recipe.place[l] * product[j];
            }
            product[0] *= -recipe.place[l];
            below *= x - recipe.place[l];
        }
        for (std::size_t j = 0; j < terms; ++j) recipe.matrix[j * terms + i] = product[j] / below;
    }
    return recipe;
}

}  // namespace batten::lagrange

namespace batten {

std::vector<double> lagrange_weights(std::span<const double> nodes, double t) {
    lagrange::require_increasing(nodes);
    std::vector<double> weights;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
        double above = 1, below = 1;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (i == j) continue;
            above *= t - nodes[i];
            below *= nodes[j] - nodes[i];
        }
        weights.push_back(above / below);
    }
    return weights;
}

}  // namespace batten
