#include "make/interpolate/chords.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"

namespace batten::interpolation {
namespace {

// Between these lengths no square that matters overflows or loses a digit.
constexpr double least_safe = 0x1p-480;
constexpr double most_safe = 0x1p480;

/// Lengths from plain squares, the first `count` of them. Says whether no square has overflowed or
/// lost digits (or is a NaN). `Dim` is the dimension where the loop is to be a short one, else 0.
template <std::size_t Dim>
bool measure_plainly(PointsView points, std::size_t count, Chords& chords) {
    const double* p = points.coordinates().data();
    const std::size_t dim = Dim > 0 ? Dim : static_cast<std::size_t>(points.dim());
    double* const lengths = chords.lengths.data();
    double shortest = chords.shortest, longest = chords.longest, sum = 0;
    for (std::size_t i = 0; i < count; ++i, p += dim) {
        double square = 0;
        for (std::size_t k = 0; k < dim; ++k) {
            const double step = p[dim + k] - p[k];
            square += step * step;
        }
        const double length = std::sqrt(square);
        lengths[i] = length;
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
        sum += length;
    }
    chords.shortest = shortest;
    chords.longest = longest;
    return shortest >= least_safe && sum <= most_safe;
}

double distance(std::span<const double> a, std::span<const double> b) {
    std::vector<double> step(a.size());
    for (std::size_t k = 0; k < a.size(); ++k) step[k] = b[k] - a[k];
    return length_of(step);
}

void measure_with_care(PointsView points, Chords& chords) {
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < chords.lengths.size(); ++i) {
        const std::size_t next = (i + 1) % n;
        chords.lengths[i] = distance(points[i], points[next]);
        if (std::isfinite(chords.lengths[i])) continue;
        throw Error("number.overflow",
                    "chord from point " + std::to_string(i) + " to " + std::to_string(next),
                    "beyond a double", "scale the points down", {i, next});
    }
    const auto [least, most] = std::minmax_element(chords.lengths.begin(), chords.lengths.end());
    chords.shortest = *least;
    chords.longest = *most;
}

}  // namespace

double length_of(std::span<const double> vector) {
    double largest = 0, square = 0;
    for (const double x : vector) {
        largest = std::max(largest, std::fabs(x));
        square += x * x;
    }
    if (largest == 0 || !std::isfinite(largest)) return largest;
    if (largest >= least_safe && largest <= most_safe) return std::sqrt(square);
    const int exponent = std::ilogb(largest);
    square = 0;
    for (const double x : vector) {
        const double part = std::scalbn(x, -exponent);
        square += part * part;
    }
    return std::scalbn(std::sqrt(square), exponent);
}

Chords chords_with_repeats(PointsView points, bool closed) {
    const std::size_t n = points.size();
    Chords chords;
    chords.lengths.resize(n - (closed ? 0 : 1));
    chords.shortest = closed ? distance(points[n - 1], points[0]) : most_safe;
    chords.longest = closed ? chords.shortest : 0;
    if (closed) chords.lengths.back() = chords.shortest;
    const bool is_safe = points.dim() == 2 ? measure_plainly<2>(points, n - 1, chords)
                                           : measure_plainly<0>(points, n - 1, chords);
    if (!is_safe) {
        require_finite(points);
        measure_with_care(points, chords);
    }
    return chords;
}

Chords chords_of(PointsView points, bool closed) {
    Chords chords = chords_with_repeats(points, closed);
    if (chords.shortest == 0) require_distinct(points, closed);
    return chords;
}

}  // namespace batten::interpolation
