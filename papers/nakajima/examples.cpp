#include "examples.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace nakajima {
namespace {

using std::numbers::pi;

}  // namespace

using namespace batten;

double Example::x(double t) const { return name == 'A' ? 2 * std::cos(t) : 4 * t / pi; }
double Example::y(double t) const { return name == 'C' ? std::cos(t) : std::sin(t); }

std::optional<double> Example::height(double at) const {
    if (name == 'A' && std::fabs(at) > 2) return std::nullopt;
    if (name == 'A') return std::sqrt(1 - at * at / 4);
    return y(at * pi / 4);
}

double Example::start_angle() const {
    if (name == 'A') return pi / 2;
    return name == 'B' ? std::atan2(1, 4 / pi) : 0;
}

Points Example::points(int n) const {
    Points points(0, 2);
    for (int i = 0; i <= n; ++i) points.push_back(std::array{x(pi * i / n), y(pi * i / n)});
    return points;
}

std::optional<double> Example::error(const std::vector<double>& p) const {
    const std::optional<double> theory = height(p[0]);
    return theory ? std::optional(100 * (p[1] - *theory)) : std::nullopt;
}

ErrorCurve errors_of(const Example& example, const Curve& curve) {
    constexpr int steps = 64;
    ErrorCurve errors;
    Points run(0, 2);
    const std::size_t cells = curve.pieces();
    for (std::size_t i = 0; i < cells * steps + 1; ++i) {
        const std::size_t cell = std::min(i / steps, cells - 1);
        const double share = static_cast<double>(i - cell * steps) / steps;
        const double at = (static_cast<double>(cell) + share) / static_cast<double>(cells);
        const std::optional<double> error =
            example.error(curve(curve.piece(cell).lo + share * curve.piece(cell).length()));
        if (error) run.push_back(std::array{at, *error});
        if ((!error || i == cells * steps) && run.size() > 1) errors.runs.push_back(run);
        if (!error) run = Points(0, 2);
        if (!error || i % (steps / 4) != 0 || i % steps == 0) continue;
        errors.at_quarters.push_back(std::array{at, *error});
        if (std::fabs(*error) > std::fabs(errors.largest) * (1 + 1e-9)) errors.largest = *error;
    }
    return errors;
}

Curve lagrange_curve(const Example& example, int n, int degree) {
    DensifyOptions options;
    options.degree = degree;
    return densify(example.points(n), options).curve;
}

ArcChain arc_curve(const Example& example, int n) {
    ArcsOptions options;
    options.method = ArcMethod::chain;
    options.start_angle = Angle{example.start_angle()};
    return arcs(example.points(n), options).chain;
}

}  // namespace nakajima
