#include "measure/surface/line_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "batten/shape/piecewise_cubic.hpp"

namespace batten::contouring {

void reverse(std::vector<LinePiece>& pieces) {
    std::reverse(pieces.begin(), pieces.end());
    for (LinePiece& piece : pieces) std::swap(piece.a, piece.b);
}

void exchange(std::vector<LinePiece>& pieces) {
    reverse(pieces);
    for (LinePiece& piece : pieces) {
        for (LinePoint* const point : {&piece.a, &piece.b}) {
            *point = {point->y, point->x, -point->dy, -point->dx};
        }
    }
}

CubicEnds ends_of(const LinePoint& a, const LinePoint& b) {
    const double x = b.x - a.x, y = b.y - a.y, chord = std::hypot(x, y);
    const bool has_both = (a.dx != 0 || a.dy != 0) && (b.dx != 0 || b.dy != 0);
    const double cosine = a.dx * b.dx + a.dy * b.dy;
    const bool is_forward = a.dx * x + a.dy * y > 0 && b.dx * x + b.dy * y > 0;
    if (!has_both || !is_forward || !(cosine > 0)) return {x, y, x, y};
    // chord / cos(turn / 4)^2, with cos(turn / 2) = sqrt((1 + cosine) / 2).
    const double length = 2 * chord / (1 + std::sqrt(0.5 * (1 + std::min(1.0, cosine))));
    return {length * a.dx, length * a.dy, length * b.dx, length * b.dy};
}

std::array<double, 2> on_cubic(const LinePoint& a, const LinePoint& b, const CubicEnds& d,
                               double u) {
    const double v = 1 - u, h0 = v * v * (1 + 2 * u), h1 = u * u * (3 - 2 * u);
    const double g0 = u * v * v, g1 = -u * u * v;
    return {h0 * a.x + h1 * b.x + g0 * d[0] + g1 * d[2],
            h0 * a.y + h1 * b.y + g0 * d[1] + g1 * d[3]};
}

Curve curve_of(const std::vector<LinePiece>& line, bool is_closed) {
    const std::size_t pieces = line.size();
    Points points(pieces + 1, 2), start(pieces, 2), end(pieces, 2);
    std::vector<double> breaks{0};
    for (std::size_t i = 0; i < pieces; ++i) {
        const LinePoint &a = line[i].a, &b = line[i].b;
        points(i, 0) = a.x;
        points(i, 1) = a.y;
        const double chord = std::hypot(b.x - a.x, b.y - a.y);
        const CubicEnds d = ends_of(a, b);
        breaks.push_back(breaks.back() + chord);
        for (int k = 0; k < 2; ++k) {
            start(i, k) = d[static_cast<std::size_t>(k)] / chord;
            end(i, k) = d[static_cast<std::size_t>(k) + 2] / chord;
        }
    }
    points(pieces, 0) = is_closed ? line.front().a.x : line.back().b.x;
    points(pieces, 1) = is_closed ? line.front().a.y : line.back().b.y;
    return PiecewiseCubic::hermite(points, start, end, std::move(breaks), is_closed);
}

}  // namespace batten::contouring
