#include "batten/base/points.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten {
namespace {

std::string describe(std::span<const double> row) {
    std::string text = "(";
    for (const double x : row) {
        text += (text.size() > 1 ? ", " : "") + format_number(x);
    }
    return text + ")";
}

bool same(std::span<const double> a, std::span<const double> b) {
    return std::equal(a.begin(), a.end(), b.begin());
}

}  // namespace

Points::Points(std::vector<double> coordinates, int dim)
    : values_(std::move(coordinates)), dim_(dim) {
    if (dim < 1 || values_.size() % static_cast<std::size_t>(dim) != 0) {
        throw Error("points.ragged", "coordinates", std::to_string(values_.size()) + " numbers",
                    "their number must be a multiple of the dimension " + std::to_string(dim));
    }
}

Points::Points(PointsView view)
    : values_(view.coordinates().begin(), view.coordinates().end()), dim_(view.dim()) {}

void Points::push_back(std::span<const double> row) {
    if (row.size() != static_cast<std::size_t>(dim_)) {
        throw Error("points.ragged", "row " + std::to_string(size()),
                    std::to_string(row.size()) + " coordinates",
                    "every row must have " + std::to_string(dim_));
    }
    values_.insert(values_.end(), row.begin(), row.end());
}

double extent(PointsView points) {
    double longest = 0;
    for (int k = 0; k < points.dim() && !points.empty(); ++k) {
        double lo = points(0, k), hi = lo;
        for (std::size_t i = 1; i < points.size(); ++i) {
            lo = std::min(lo, points(i, k));
            hi = std::max(hi, points(i, k));
        }
        longest = std::max(longest, hi - lo);
    }
    return longest;
}

void require_finite(PointsView points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (int k = 0; k < points.dim(); ++k) {
            if (!std::isfinite(points(i, k))) {
                throw Error("points.not-finite",
                            "point " + std::to_string(i) + ", coordinate " + std::to_string(k),
                            format_number(points(i, k)), "coordinates must be finite", {i});
            }
        }
    }
}

void require_count(PointsView points, std::size_t count) {
    if (points.size() < count) {
        throw Error("points.too-few", "points", std::to_string(points.size()),
                    "at least " + std::to_string(count) + " points are needed");
    }
}

void require_distinct(PointsView points, bool closed) {
    const std::size_t n = points.size();
    if (n < 2) return;
    std::size_t first_repeat = n;
    bool all_equal = true;
    for (std::size_t i = 0; i + 1 < n + (closed ? 1 : 0); ++i) {
        const bool equal = same(points[i], points[(i + 1) % n]);
        if (equal && first_repeat == n) first_repeat = i;
        if (!equal) all_equal = false;
    }
    if (all_equal) {
        throw Error("points.all-equal", "points 0 to " + std::to_string(n - 1),
                    describe(points[0]), "a curve needs two different points");
    }
    if (first_repeat < n) {
        throw Error("points.repeated",
                    "points " + std::to_string(first_repeat) + " and " +
                        std::to_string((first_repeat + 1) % n),
                    describe(points[first_repeat]), "consecutive points must differ",
                    {first_repeat, (first_repeat + 1) % n});
    }
}

void require_dimension(PointsView points, int lowest, int highest) {
    if (points.dim() < lowest || points.dim() > highest) {
        const std::string allowed = lowest == highest
                                        ? std::to_string(lowest)
                                        : std::to_string(lowest) + " to " + std::to_string(highest);
        throw Error("points.dimension", "points", std::to_string(points.dim()) + " coordinates",
                    allowed + " coordinates are needed here");
    }
}

}  // namespace batten
