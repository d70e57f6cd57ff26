#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "batten/shape/curve.hpp"

/// Lines of equal height as cubic pieces.
namespace batten::contouring {

/// A point of a line and its direction, higher ground on the left; 0, 0 at a summit.
struct LinePoint {
    double x = 0, y = 0;
    double dx = 0, dy = 0;
};

/// What a line does between two points, in one column of the lattice.
struct LinePiece {
    LinePoint a, b;
    std::size_t column = 0;

    void start_at(double x, double y) {
        a.x = x;
        a.y = y;
    }
    void end_at(double x, double y) {
        b.x = x;
        b.y = y;
    }
};

/// The same line the other way round.
void reverse(std::vector<LinePiece>& pieces);

/// The line of a surface whose x and y are exchanged: it turns round, for left becomes right.
void exchange(std::vector<LinePiece>& pieces);

/// Derivatives at both ends of the cubic over [0, 1].
using CubicEnds = std::array<double, 4>;

/// As long as those of the arc that turns from one direction to the other.
CubicEnds ends_of(const LinePoint& a, const LinePoint& b);

std::array<double, 2> on_cubic(const LinePoint& a, const LinePoint& b, const CubicEnds& d,
                               double u);

/// All pieces, the parameter the length of their chords.
Curve curve_of(const std::vector<LinePiece>& line, bool is_closed);

}  // namespace batten::contouring
