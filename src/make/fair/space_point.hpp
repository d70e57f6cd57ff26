#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace batten::fairing {

using SpacePoint = std::array<double, 3>;
using SpaceTrack = std::vector<SpacePoint>;

inline SpacePoint operator+(const SpacePoint& a, const SpacePoint& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline SpacePoint operator-(const SpacePoint& a, const SpacePoint& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline SpacePoint operator*(double s, const SpacePoint& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const SpacePoint& a, const SpacePoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline SpacePoint cross(const SpacePoint& a, const SpacePoint& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const SpacePoint& a) { return std::sqrt(dot(a, a)); }

/// Of the circle through three points.
inline double curvature(const SpacePoint& p, const SpacePoint& q, const SpacePoint& r) {
    const SpacePoint a = q - p, b = r - q;
    return 2 * norm(cross(a, b)) / (norm(a) * norm(b) * norm(a + b));
}

/// The sine of the angle between the planes of p, q, r and q, r, s over the mean edge.
inline double torsion(const SpacePoint& p, const SpacePoint& q, const SpacePoint& r,
               const SpacePoint& s) {
    const SpacePoint a = q - p, b = r - q, c = s - r;
    const SpacePoint m = cross(a, b), n = cross(b, c);
    const double size = norm(m) * norm(n) * norm(b);
    return size > 0 ? 3 * dot(cross(m, n), b) / (size * (norm(a) + norm(b) + norm(c))) : 0;
}

}  // namespace batten::fairing
