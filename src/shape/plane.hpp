#pragma once

#include <array>
#include <cmath>
#include <span>

#include "batten/base/points.hpp"

/// Vectors of the plane, for code that is about the plane only.
namespace batten::plane {

struct Vector {
    double x = 0;
    double y = 0;
    bool operator==(const Vector&) const = default;
};

inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
inline Vector operator-(Vector a) { return {-a.x, -a.y}; }
inline Vector operator*(double s, Vector a) { return {s * a.x, s * a.y}; }

inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
/// Positive where b lies to the left of a.
inline double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
inline double norm(Vector a) { return std::hypot(a.x, a.y); }
/// `a` turned by a quarter to the left.
inline Vector left_of(Vector a) { return {-a.y, a.x}; }
/// `a` turned to the left by the angle with this cosine and sine.
inline Vector turned(Vector a, double cosine, double sine) {
    return {cosine * a.x - sine * a.y, sine * a.x + cosine * a.y};
}
inline Vector direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
/// `a` with the length 1. Only where `a` is not zero.
inline Vector unit(Vector a) { return (1 / norm(a)) * a; }
/// The angle from a to b, in [-pi, pi], positive to the left.
inline double angle_between(Vector a, Vector b) { return std::atan2(cross(a, b), dot(a, b)); }

inline Vector vector(std::span<const double> a) { return {a[0], a[1]}; }
inline std::array<double, 2> array(Vector a) { return {a.x, a.y}; }
inline Vector at(PointsView points, std::size_t row) { return {points(row, 0), points(row, 1)}; }

}  // namespace batten::plane
