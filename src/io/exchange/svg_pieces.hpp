#pragma once

#include <array>
#include <vector>

#include "batten/shape/curve.hpp"

/// The segments of SVG path data on their way to a curve.
namespace batten::path_data {

struct Point {
    double x = 0;
    double y = 0;
    bool operator==(const Point&) const = default;
};

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double f, Point p) { return {f * p.x, f * p.y}; }

/// One Bezier segment: degree + 1 control points. With `inner_weight` other than 1 it is a
/// rational cubic, its ends of weight 1.
struct Piece {
    int degree = 1;
    std::array<Point, 4> points{};
    double inner_weight = 1;

    Point start() const { return points[0]; }
    Point end() const { return points[static_cast<std::size_t>(degree)]; }
    /// Whether all control points are one.
    bool is_point() const;
    /// The same segment in cubic form.
    Piece elevated() const;
};

/// The parameters of the command A, as they are written.
struct Arc {
    Point start;
    Point radii;
    double rotation_degrees = 0;
    bool is_large = false;
    bool is_increasing = false;  ///< the flag `sweep`: by increasing angle from x to y
    Point end;
};

/// Appends the arc in pieces of at most a quarter turn: exact rational Bezier segments. A straight
/// line where a radius is 0; nothing where it ends at its start.
/// Source: [SVG2, appendix B.2.4 and B.2.5].
void append_arc(std::vector<Piece>& pieces, const Arc& arc);

/// Piece i over [i, i + 1]. Polynomial pieces give a PiecewiseCubic, others a rational B-spline.
enum class Ends { open, closed };
Curve joined(const std::vector<Piece>& pieces, Ends ends);

}  // namespace batten::path_data
