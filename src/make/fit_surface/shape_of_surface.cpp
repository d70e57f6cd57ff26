#include "make/fit_surface/shape_of_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "num/rows.hpp"

namespace batten::surface_fitting {
namespace {

constexpr std::size_t most_places = 64;  // a sample of the grid's lines is enough for a share

std::vector<double> thinned(std::span<const double> lines) {
    const std::size_t step = (lines.size() + most_places - 1) / most_places;
    std::vector<double> places;
    for (std::size_t i = 0; i < lines.size(); i += step) places.push_back(lines[i]);
    return places;
}

/// A sum of squared deviations that is but the rounding of the heights.
double rounding_of(const Grid& z) {
    constexpr double share = 256 * std::numeric_limits<double>::epsilon();
    return share * share * num::sum_of_squares(z.view().values());
}

double additive_rest(const Grid& z) {
    const std::size_t m = z.nu(), n = z.nv();
    std::vector<double> row(m, 0.0), column(n, 0.0);
    double mean = 0;
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            row[i] += z(i, j) / static_cast<double>(n);
            column[j] += z(i, j) / static_cast<double>(m);
            mean += z(i, j) / static_cast<double>(m * n);
        }
    }
    double all = 0, rest = 0;
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const double deviation = z(i, j) - mean;
            const double interaction = z(i, j) - row[i] - column[j] + mean;
            all += deviation * deviation;
            rest += interaction * interaction;
        }
    }
    return all > rounding_of(z) ? std::min(1.0, rest / all) : 0;
}

/// All rows added, each with the sign that makes the sum longer: of a product a multiple of every
/// row, whatever the signs of its heights.
std::vector<double> aligned_sum(std::span<const double> values, std::size_t m, std::size_t n) {
    std::vector<double> sum(n, 0.0);
    for (std::size_t i = 0; i < m; ++i) {
        const std::span<const double> row = values.subspan(i * n, n);
        num::add_times(num::dot(row, sum) < 0 ? -1 : 1, row, sum);
    }
    return sum;
}

/// 1 less the largest squared singular value's share, by power iteration.
double product_rest(const Grid& z) {
    const std::size_t m = z.nu(), n = z.nv();
    const std::span<const double> values = z.view().values();
    const double all = num::sum_of_squares(values);
    std::vector<double> v = aligned_sum(values, m, n), u(m);
    double largest_sq = 0;
    for (int round = 0; round < 200 && all > 0; ++round) {
        const double scale = 1 / std::sqrt(num::sum_of_squares(v));
        for (double& x : v) x *= scale;
        std::fill(u.begin(), u.end(), 0.0);
        num::add_dots(values, v, u);
        const double next = num::sum_of_squares(u);
        std::fill(v.begin(), v.end(), 0.0);
        num::add_combination(u, values, v);
        const bool is_still = std::fabs(next - largest_sq) <= 1e-12 * all;
        largest_sq = next;
        if (is_still) break;
    }
    return all > 0 ? std::max(0.0, 1 - largest_sq / all) : 0;
}

std::vector<double> middles(std::span<const double> lines) {
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        result.push_back(Interval{lines[i], lines[i + 1]}.middle());
    }
    return result;
}

Grid heights(const SplineSurface& surface, std::span<const double> x, std::span<const double> y) {
    return surface.evaluate(x, y);
}

Grid heights(const CurvedKnotSurface& surface, std::span<const double> x,
             std::span<const double> y) {
    Grid z(x.size(), y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = 0; j < y.size(); ++j) z(i, j) = surface(x[i], y[j]);
    }
    return z;
}

template <class Any>
Separability separability_of(const Any& surface, std::span<const double> x,
                             std::span<const double> y) {
    const Grid z = heights(surface, thinned(x), thinned(y));
    return {additive_rest(z), product_rest(z)};
}

template <class Any>
double oscillation_of(const Any& surface, std::span<const double> x, std::span<const double> y) {
    const std::span<const double> xs = x.first(std::min(x.size(), most_places));
    const std::span<const double> ys = y.first(std::min(y.size(), most_places));
    const Grid nodes = heights(surface, xs, ys);
    const Grid between = heights(surface, middles(xs), middles(ys));
    double fine = 0, coarse = 0, cells = 0, blocks = 0;
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
        for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
            const double corners = nodes(i, j) + nodes(i + 1, j) + nodes(i, j + 1) +
                                   nodes(i + 1, j + 1);
            const double gap = between(i, j) - 0.25 * corners;
            fine += gap * gap;
            cells += 1;
            if (i == 0 || j == 0) continue;
            const double around = nodes(i - 1, j - 1) + nodes(i + 1, j - 1) +
                                  nodes(i - 1, j + 1) + nodes(i + 1, j + 1);
            const double wide = 0.25 * (nodes(i, j) - 0.25 * around);
            coarse += wide * wide;
            blocks += 1;
        }
    }
    constexpr double rounding = 1e-10;
    double largest = 0;
    for (const double z : nodes.view().values()) largest = std::max(largest, std::fabs(z));
    const bool bends = std::sqrt(fine / cells) > rounding * largest;
    return bends && coarse > 0 ? std::sqrt(fine / cells / (coarse / blocks)) : 0;
}

}  // namespace

Separability separability(const SplineSurface& surface, std::span<const double> x,
                          std::span<const double> y) {
    return separability_of(surface, x, y);
}

Separability separability(const CurvedKnotSurface& surface, std::span<const double> x,
                          std::span<const double> y) {
    return separability_of(surface, x, y);
}

double oscillation(const SplineSurface& surface, std::span<const double> x,
                   std::span<const double> y) {
    return oscillation_of(surface, x, y);
}

double oscillation(const CurvedKnotSurface& surface, std::span<const double> x,
                   std::span<const double> y) {
    return oscillation_of(surface, x, y);
}

}  // namespace batten::surface_fitting
