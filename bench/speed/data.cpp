#include "data.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "batten/make/interpolate.hpp"

namespace batten::bench {

Points wave(std::size_t n) {
    Points points(n, 2);
    for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(i);
        points(i, 0) = x + 0.3 * std::sin(x);
        points(i, 1) = std::sin(0.7 * x) + 0.2 * std::cos(1.9 * x);
    }
    return points;
}

Points sharp_way(std::size_t n) {
    constexpr double most = 100 * std::numbers::pi / 180;
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<double> turn(-most, most), step(0.5, 1.5);
    Points points(n, 2);
    double x = 0, y = 0, direction = 0;
    for (std::size_t i = 0; i < n; ++i) {
        points(i, 0) = x;
        points(i, 1) = y;
        direction += turn(engine);
        const double length = step(engine);
        x += length * std::cos(direction);
        y += length * std::sin(direction);
    }
    return points;
}

void fill_chord_parameters(const Points& points, std::span<double> t) {
    t[0] = 0;
    for (std::size_t i = 1; i < t.size(); ++i) {
        const double x = points(i, 0) - points(i - 1, 0), y = points(i, 1) - points(i - 1, 1);
        t[i] = t[i - 1] + std::sqrt(x * x + y * y);
    }
}

std::vector<double> heights(std::size_t n) {
    std::vector<double> y(n);
    for (std::size_t i = 0; i < n; ++i) y[i] = std::sin(0.7 * static_cast<double>(i));
    return y;
}

Curve height_curve(std::size_t knots) {
    InterpolateOptions options;
    options.method = Method::natural_uniform;
    return curve_through(Points(heights(knots), 1), options);
}

std::vector<double> random_parameters(std::size_t count, double top) {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> within(0, top);
    std::vector<double> t(count);
    for (double& x : t) x = within(engine);
    return t;
}

std::vector<double> sorted_parameters(std::size_t count, double top) {
    std::vector<double> t = random_parameters(count, top);
    std::sort(t.begin(), t.end());
    return t;
}

std::string name_of(const std::string& operation, const std::string& peer, std::size_t size) {
    return operation + '/' + peer + '/' + std::to_string(size);
}

}  // namespace batten::bench
