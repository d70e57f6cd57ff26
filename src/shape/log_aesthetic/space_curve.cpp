#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/log_aesthetic_space.hpp"

namespace batten {
namespace {

using Vector = std::array<double, 3>;
using Motion = LogAestheticSpaceCurve::Motion;

Vector operator+(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A velocity of the rigid motions: rotation and translation, in the moving frame.
struct Twist {
    Vector turn, shift;
};
Twist operator+(const Twist& a, const Twist& b) { return {a.turn + b.turn, a.shift + b.shift}; }
Twist operator*(double s, const Twist& a) { return {s * a.turn, s * a.shift}; }

/// The bracket of body velocities, with the sign of y' = y A.
Twist bracket(const Twist& a, const Twist& b) {
    return {-1.0 * cross(a.turn, b.turn),
            -1.0 * (cross(a.turn, b.shift) + cross(a.shift, b.turn))};
}

/// The motion by e^twist, seen from `from`.
Motion moved(const Motion& from, const Twist& twist) {
    const double angle_sq = dot(twist.turn, twist.turn), angle = std::sqrt(angle_sq);
    const bool is_small = angle < 1e-2;
    const double s = is_small ? 1 - angle_sq / 6 * (1 - angle_sq / 20) : std::sin(angle) / angle;
    const double half = std::sin(0.5 * angle);
    const double c = is_small ? 0.5 - angle_sq / 24 * (1 - angle_sq / 30)
                              : 2 * half * half / angle_sq;
    const double d = is_small ? 1.0 / 6 - angle_sq / 120 * (1 - angle_sq / 42)
                              : (1 - s) / angle_sq;
    const auto turned = [&](const Vector& v, double first, double second) {
        const Vector w = cross(twist.turn, v);
        return v + (first * w + second * cross(twist.turn, w));
    };
    const auto to_space = [&](const Vector& v) {
        return v[0] * from.tangent + (v[1] * from.normal + v[2] * from.binormal);
    };
    return {from.point + to_space(turned(twist.shift, c, d)), to_space(turned({1, 0, 0}, s, c)),
            to_space(turned({0, 1, 0}, s, c)), to_space(turned({0, 0, 1}, s, c))};
}

void require(bool is_good, double value, const char* rule) {
    if (!is_good) throw Error("log-aesthetic.pieces", "space curve", format_number(value), rule);
}

void require_law(const RadiusLaw& law, double length) {
    for (const double s : {0.0, length}) {
        const double k = law.curvature(s);
        require(std::isfinite(k) && k > 0, k, "radii must be finite and above 0 all along");
    }
}

double log_change(const RadiusLaw& law, double length) {
    return std::fabs(std::log(law.curvature(0) / law.curvature(length)));
}

}  // namespace

double RadiusLaw::curvature(double s) const {
    if (exponent == 0) return std::exp(-d * s) / c;
    return std::pow(c * s + d, -1 / exponent);
}

void RadiusLaw::jet(double s, std::span<double> out) const {
    if (out.empty()) return;
    out[0] = curvature(s);
    const double g = exponent == 0 ? -d : -c / (exponent * (c * s + d));
    for (std::size_t j = 1; j < out.size(); ++j) {
        out[j] = out[j - 1] * g * (1 + double(j - 1) * exponent);
    }
}

LogAestheticSpaceCurve::LogAestheticSpaceCurve(RadiusLaw curvature, RadiusLaw torsion,
                                               double length, const SpaceFrame& start)
    : curvature_(curvature), torsion_(torsion), breaks_{0, length} {
    require(std::isfinite(length) && length > 0, length, "the length must be finite and above 0");
    require_law(curvature, length);
    require_law(torsion, length);
    const double skew = std::fabs(dot(start.tangent, start.tangent) - 1) +
                        std::fabs(dot(start.normal, start.normal) - 1) +
                        std::fabs(dot(start.tangent, start.normal));
    require(skew < 1e-9, skew, "tangent and normal must be orthonormal");
    const double most = std::fmax(curvature.curvature(0), curvature.curvature(length)) +
                        std::fmax(torsion.curvature(0), torsion.curvature(length));
    // Order 6: a twelfth of a radian, or of the radii's change, leaves 1e-14 a step.
    const double change =
        most * length + log_change(curvature, length) + log_change(torsion, length);
    require(change < 1e5, change, "the curve must turn by less than 1e5 in all");
    const int steps = static_cast<int>(std::ceil(12 * change)) + 4;
    nodes_.push_back(
        {start.point, start.tangent, start.normal, cross(start.tangent, start.normal)});
    for (int i = 0; i < steps; ++i) {
        nodes_.push_back(stepped(nodes_.back(), length * i / steps, length / steps));
    }
}

/// [BlanesCasasOteoRos2009]: order 6 from three Gauss nodes.
Motion LogAestheticSpaceCurve::stepped(const Motion& from, double s, double step) const {
    const double offset = std::sqrt(0.15) * step, middle = s + 0.5 * step;
    const auto velocity = [&](double at) {
        return Twist{{torsion_.curvature(at), 0, curvature_.curvature(at)}, {1, 0, 0}};
    };
    const Twist a = velocity(middle - offset), b = velocity(middle), c = velocity(middle + offset);
    const Twist first = step * b;
    const Twist second = (std::sqrt(15.0) / 3 * step) * (c + -1.0 * a);
    const Twist third = (10.0 / 3 * step) * (c + (-2.0 * b + a));
    const Twist c1 = bracket(first, second);
    const Twist c2 = (-1.0 / 60) * bracket(first, 2.0 * third + c1);
    const Twist sum = -20.0 * first + (-1.0 * third + c1);
    return moved(from, first + ((1.0 / 12) * third + (1.0 / 240) * bracket(sum, second + c2)));
}

Motion LogAestheticSpaceCurve::motion(double s) const {
    const double steps = double(nodes_.size() - 1), length = breaks_[1];
    const double node = std::clamp(std::floor(s / length * steps), 0.0, steps - 1);
    const double at = length * node / steps;
    return stepped(nodes_[static_cast<std::size_t>(node)], at, s - at);
}

void LogAestheticSpaceCurve::jets_on(std::size_t, std::span<const double> t, int order,
                                     std::span<double> out) const {
    const std::size_t count = static_cast<std::size_t>(order);
    std::vector<double> kappa(count), tau(count);
    std::vector<Vector> T(count), N(count), B(count);
    for (std::size_t i = 0; i < t.size(); ++i) {
        const Motion here = motion(t[i]);
        double* const row = out.data() + i * 3 * (count + 1);
        std::copy(here.point.begin(), here.point.end(), row);
        if (count == 0) continue;
        curvature_.jet(t[i], kappa);
        torsion_.jet(t[i], tau);
        // Frenet's equations for the power series of the frame.
        T[0] = here.tangent, N[0] = here.normal, B[0] = here.binormal;
        double factorial = 1;
        for (std::size_t k = 0; k + 1 < count; ++k) {
            if (k > 1) factorial *= double(k);
            kappa[k] /= factorial, tau[k] /= factorial;
            T[k + 1] = N[k + 1] = B[k + 1] = {0, 0, 0};
            for (std::size_t j = 0; j <= k; ++j) {
                T[k + 1] = T[k + 1] + kappa[j] * N[k - j];
                N[k + 1] = N[k + 1] + (-kappa[j] * T[k - j] + tau[j] * B[k - j]);
                B[k + 1] = B[k + 1] + -tau[j] * N[k - j];
            }
            for (Vector* v : {&T[k + 1], &N[k + 1], &B[k + 1]}) *v = (1 / double(k + 1)) * *v;
        }
        double scale = 1;
        for (std::size_t k = 0; k < count; ++k) {
            if (k > 0) scale *= double(k);
            for (std::size_t x = 0; x < 3; ++x) row[3 * (k + 1) + x] = scale * T[k][x];
        }
    }
}

}  // namespace batten
