#include "joukowski.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace nakajima {
namespace {

using batten::Points;
using Complex = std::complex<double>;

using std::numbers::pi;
constexpr double rise = 5 * pi / 180;
const Complex centre(-0.1, 0.08);
const double radius = std::abs(1.0 - centre);
const double tail_angle = std::arg(1.0 - centre);
const double circulation = 4 * pi * radius * std::sin(rise - tail_angle);

Complex on_circle(double angle) { return centre + std::polar(radius, tail_angle + angle); }
Complex to_plane(Complex w) { return w + 1.0 / w; }

/// The w outside the circle that is mapped to z.
Complex from_plane(Complex z) {
    const Complex root = std::sqrt(z * z / 4.0 - 1.0);
    const Complex one = z / 2.0 + root, other = z / 2.0 - root;
    return std::abs(one - centre) > std::abs(other - centre) ? one : other;
}

double stream_function(Complex z) {
    const Complex w = from_plane(z) - centre, along = std::polar(1.0, -rise);
    const Complex flow = w * along + radius * radius / (w * along) +
                         Complex(0, circulation / (2 * pi)) * std::log(w / radius);
    return flow.imag();
}

}  // namespace

std::array<double, 2> aerofoil_point(double angle) {
    const Complex z = to_plane(on_circle(angle));
    return {z.real(), z.imag()};
}

double aerofoil_distance(std::span<const double> point, batten::Interval angles) {
    const auto distance = [&](double angle) {
        const auto [x, y] = aerofoil_point(angle);
        return std::hypot(x - point[0], y - point[1]);
    };
    while (angles.length() > 1e-9) {  // one least distance in such a short part
        const double third = angles.length() / 3;
        const bool is_left = distance(angles.lo + third) < distance(angles.hi - third);
        (is_left ? angles.hi : angles.lo) += is_left ? -third : third;
    }
    return distance(angles.middle());
}

double chord() {
    double nose = 0;
    for (int i = 0; i <= 20000; ++i) nose = std::min(nose, aerofoil_point(2 * pi * i / 20000)[0]);
    return 2 - nose;
}

double start_angle(Side side) { return side == Side::upper ? 0 : pi; }

Points aerofoil_points(Side side, int n) {
    const double from = start_angle(side);
    Points points(0, 2);
    for (int i = 0; i <= n; ++i) points.push_back(aerofoil_point(from + i * pi / n));
    return points;
}

double stream_height(double x, double psi) {
    const double at_body = stream_function(to_plane(on_circle(0)));
    // Above (below) the aerofoil the stream function rises with y from the body's own value.
    const bool is_beside = x > aerofoil_point(pi)[0] && x < 2;
    double low = psi <= 0 ? -4 : is_beside ? 0.1 : -0.9;
    double high = psi > 0 ? 4 : is_beside ? 0 : 0.9;
    for (int halving = 0; halving < 80; ++halving) {
        const double y = (low + high) / 2;
        (stream_function({x, y}) - at_body < psi ? low : high) = y;
    }
    return (low + high) / 2;
}

Points stream_points(double psi) {
    Points points(0, 2);
    for (const double x : {-4.0, -2.8, -2.0, -1.0, 0.2, 1.4, 2.6, 4.0}) {
        points.push_back(std::array{x, stream_height(x, psi)});
    }
    return points;
}

}  // namespace nakajima
