#include "io/exchange/svg_pieces.hpp"

#include <algorithm>

#include "batten/shape/bspline.hpp"
#include "batten/shape/piecewise_cubic.hpp"

namespace batten::path_data {
namespace {

/// Power coefficients 1, 2 and 3 over a parameter interval of length 1; exact zeros beyond the
/// piece's degree.
std::array<Point, 3> powers(const Piece& piece) {
    const auto& p = piece.points;
    if (piece.degree == 1) return {p[1] - p[0], Point{}, Point{}};
    if (piece.degree == 2) {
        return {2 * (p[1] - p[0]), (p[2] - p[1]) - (p[1] - p[0]), Point{}};
    }
    const Point first = p[1] - p[0], second = p[2] - p[1], third = p[3] - p[2];
    return {3 * first, 3 * (second - first), (third - second) - (second - first)};
}

std::vector<double> unit_breaks(std::size_t pieces) {
    std::vector<double> breaks(pieces + 1);
    for (std::size_t i = 0; i <= pieces; ++i) breaks[i] = static_cast<double>(i);
    return breaks;
}

Curve as_cubics(const std::vector<Piece>& pieces, Ends ends) {
    const std::size_t n = pieces.size(), joints = n + 1;
    std::vector<double> block(8 * joints, 0.0);
    const auto put = [&](std::size_t power, std::size_t i, Point p) {
        block[(2 * power) * joints + i] = p.x;
        block[(2 * power + 1) * joints + i] = p.y;
    };
    for (std::size_t i = 0; i < n; ++i) {
        put(0, i, pieces[i].start());
        const std::array<Point, 3> c = powers(pieces[i]);
        for (std::size_t power = 1; power <= 3; ++power) put(power, i, c[power - 1]);
    }
    put(0, n, pieces.back().end());
    return PiecewiseCubic::power(std::move(block), 2, unit_breaks(n), ends == Ends::closed);
}

/// Every break is a knot of multiplicity 3: the control points are those of the pieces.
Curve as_rational(const std::vector<Piece>& pieces, Ends ends) {
    const std::size_t n = pieces.size();
    std::vector<double> knots;
    for (std::size_t i = 0; i < 3 * n; ++i) knots.push_back(static_cast<double>(i / 3));
    knots.push_back(static_cast<double>(n));
    if (ends == Ends::open) {
        knots.insert(knots.begin(), 0.0);
        knots.insert(knots.end(), 3, static_cast<double>(n));
    }
    const BSplineBasis basis = ends == Ends::closed ? BSplineBasis::periodic(knots, 3)
                                                    : BSplineBasis(std::move(knots), 3);
    Points control(basis.size(), 2);
    std::vector<double> weights(basis.size(), 1.0);
    for (std::size_t i = 0; i < n; ++i) {
        const Piece piece = pieces[i].elevated();
        const std::size_t span = basis.span_of_piece(i);
        for (int j = 3; j >= 0; --j) {
            const std::size_t place = basis.control(span, j);
            const Point p = piece.points[static_cast<std::size_t>(j)];
            control(place, 0) = p.x;
            control(place, 1) = p.y;
            if (j == 1 || j == 2) weights[place] = piece.inner_weight;
        }
    }
    return BSplineCurve(basis, std::move(control), std::move(weights));
}

}  // namespace

bool Piece::is_point() const {
    return std::all_of(points.begin(), points.begin() + degree + 1,
                       [&](Point p) { return p == points[0]; });
}

Piece Piece::elevated() const {
    if (degree == 3) return *this;
    const Point start_handle = degree == 1 ? end() : points[1];
    const Point end_handle = degree == 1 ? start() : points[1];
    const double share = degree == 1 ? 1.0 / 3 : 2.0 / 3;
    return {3,
            {start(), start() + share * (start_handle - start()), end() + share * (end_handle - end()),
             end()},
            1};
}

Curve joined(const std::vector<Piece>& pieces, Ends ends) {
    const bool is_rational = std::any_of(pieces.begin(), pieces.end(),
                                         [](const Piece& p) { return p.inner_weight != 1; });
    return is_rational ? as_rational(pieces, ends) : as_cubics(pieces, ends);
}

}  // namespace batten::path_data
