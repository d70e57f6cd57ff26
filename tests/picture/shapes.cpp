#include <array>
#include <cmath>
#include <numbers>

#include "batten/shape/piecewise_cubic.hpp"
#include "pictures.hpp"

namespace batten::testing {
namespace {

std::array<double, 2> chord(PointsView points, std::size_t from, std::size_t to) {
    return {points(to, 0) - points(from, 0), points(to, 1) - points(from, 1)};
}

std::array<double, 2> direction(PointsView points, std::size_t from, std::size_t to) {
    const auto [x, y] = chord(points, from, to);
    return {x / std::hypot(x, y), y / std::hypot(x, y)};
}

}  // namespace

Curve hermite_chord(PointsView given, Seam seam) {
    Points points(given);
    if (seam != Seam::open) points.push_back(given[0]);
    const std::size_t last = points.size() - 1;
    Points tangents(0, 2);
    std::vector<double> breaks{0};
    for (std::size_t i = 0; i <= last; ++i) {
        const bool wraps = seam == Seam::smooth && (i == 0 || i == last);
        const std::size_t before = wraps ? last - 1 : i == 0 ? 0 : i - 1;
        const std::size_t after = wraps ? 1 : i == last ? last : i + 1;
        tangents.push_back(direction(points, before, after));
        if (i < last) {
            const auto [x, y] = chord(points, i, i + 1);
            breaks.push_back(breaks.back() + std::hypot(x, y));
        }
    }
    return PiecewiseCubic::hermite(points, tangents.view().part(0, last),
                                   tangents.view().part(1, last), breaks, seam != Seam::open);
}

Curve near_circle(double radius) {
    const double k = 4 * (std::numbers::sqrt2 - 1) * radius;  // three thirds of the usual handle
    const double r = radius;
    const Points points({r, 0, 0, r, -r, 0, 0, -r, r, 0}, 2);
    const Points tangents({0, k, -k, 0, 0, -k, k, 0, 0, k}, 2);
    return PiecewiseCubic::hermite(points, tangents.view().part(0, 4), tangents.view().part(1, 4),
                                   {0, 1, 2, 3, 4}, true);
}

Curve exact_circle(double radius) {
    const auto jet = [radius](double t, int order, std::span<double> out) {
        for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
            const double angle = t + 0.5 * std::numbers::pi * static_cast<double>(k);
            out[2 * k] = radius * std::cos(angle);
            out[2 * k + 1] = radius * std::sin(angle);
        }
    };
    return CallableCurve{jet, 2, {0, 2 * std::numbers::pi}, true};
}

Curve helix() {
    const auto jet = [](double t, int order, std::span<double> out) {
        for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
            const double angle = t + 0.5 * std::numbers::pi * static_cast<double>(k);
            out[3 * k] = 3 * std::cos(angle);
            out[3 * k + 1] = 2 * std::sin(angle);
            out[3 * k + 2] = k == 0 ? 0.25 * t : k == 1 ? 0.25 : 0;
        }
    };
    return CallableCurve{jet, 3, {0, 3 * std::numbers::pi}, false};
}

Curve drop() {
    const double k = 4 * (std::numbers::sqrt2 - 1);
    const Points points({0, -2.6, 1, 0, 0, 1, -1, 0, 0, -2.6}, 2);
    const Points start({1, 2.2, 0, k, -k, 0, 0, -3}, 2);
    const Points end({0, 3, -k, 0, 0, -k, 1, -2.2}, 2);
    return PiecewiseCubic::hermite(points, start, end, {0, 1, 2, 3, 4}, true);
}

Points guitar() {
    return Points({0,    -10.2, 4.0, -9.8, 7.1, -7.6, 7.9, -4.2, 6.5, -1.0, 4.9, 1.3, 4.8, 3.6,
                   5.7,  5.9,   5.4, 8.2,  3.6, 9.6,  1.4, 9.9,  0,   9.7,  -1.4, 9.9, -3.6, 9.6,
                   -5.4, 8.2,  -5.7, 5.9, -4.8, 3.6, -4.9, 1.3, -6.5, -1.0, -7.9, -4.2, -7.1, -7.6,
                   -4.0, -9.8},
                  2);
}

Points zigzag() { return Points({0, 0, 2, -0.1, 1, -0.1, 3, 0}, 2); }

}  // namespace batten::testing
