#include <algorithm>
#include <array>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/shape/transform.hpp"
#include "io/exchange/svg_pieces.hpp"

namespace batten {
namespace {

using path_data::Piece;
using path_data::Point;

Point coefficient(const PiecewiseCubic& curve, int power, std::size_t piece) {
    return {curve.coefficients(power, 0)[piece], curve.coefficients(power, 1)[piece]};
}

PiecewiseCubic plane_cubic(const Curve& curve) {
    if (curve.dim() != 2) {
        throw Error("curve.dimension", "curve", std::to_string(curve.dim()) + " coordinates",
                    "SVG path data take two coordinates");
    }
    if (std::optional<PiecewiseCubic> cubic = exact_cubic(curve)) return *std::move(cubic);
    throw Error("curve.not-exact", "curve",
                curve.degree() ? "degree " + std::to_string(*curve.degree()) : "no polynomial",
                "SVG path data take lines and cubics: convert the curve to cubic pieces first");
}

/// The control points of one piece, from the derivatives at both its ends.
Piece bezier(const PiecewiseCubic& curve, std::size_t i) {
    const double start_t = curve.breaks()[i], end_t = curve.breaks()[i + 1];
    const double third = (end_t - start_t) / 3;
    const Point start = coefficient(curve, 0, i), end = coefficient(curve, 0, i + 1);
    if (coefficient(curve, 2, i) == Point{} && coefficient(curve, 3, i) == Point{}) {
        return {1, {start, end}};
    }
    std::array<double, 4> last{};
    curve.jets_on(i, {&end_t, 1}, 1, last);
    const Point end_slope{last[2], last[3]};
    return {3, {start, start + third * coefficient(curve, 1, i), end - third * end_slope, end}};
}

std::vector<Piece> beziers(const Curve& curve) {
    const PiecewiseCubic cubic = plane_cubic(curve);
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < cubic.pieces(); ++i) {
        pieces.push_back(bezier(cubic, i));
        for (const Point p : pieces.back().points) {
            if (std::isfinite(p.x) && std::isfinite(p.y)) continue;
            throw Error("number.overflow", "control point of piece " + std::to_string(i),
                        "beyond a double", "results must lie within the range of a double");
        }
    }
    return pieces;
}

void append(std::string& text, Point p) {
    text += format_number(p.x) + ' ' + format_number(p.y);
}

std::string path_text(const std::vector<Piece>& pieces, bool is_closed) {
    std::string text = "M ";
    append(text, pieces.front().start());
    for (const Piece& piece : pieces) {
        text += piece.degree == 1 ? " L" : " C";
        for (int i = 1; i <= piece.degree; ++i) {
            text += ' ';
            append(text, piece.points[static_cast<std::size_t>(i)]);
        }
    }
    return is_closed ? text + " Z" : text;
}

}  // namespace

std::string svg_path(const Curve& curve) { return path_text(beziers(curve), curve.is_closed()); }

std::string svg_picture(const Curve& curve) {
    const std::vector<Piece> pieces = beziers(curve);
    Point low = pieces.front().start(), high = low;
    for (const Piece& piece : pieces) {
        for (int i = 0; i <= piece.degree; ++i) {
            const Point p = piece.points[static_cast<std::size_t>(i)];
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    }
    const double size = std::max(high.x - low.x, high.y - low.y);
    const double margin = 0.04 * size;
    const Point room = high - low + Point{2 * margin, 2 * margin};
    if (!std::isfinite(room.x) || !std::isfinite(room.y)) {
        throw Error("number.overflow", "extent", "beyond a double",
                    "results must lie within the range of a double");
    }
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
    append(text, {low.x - margin, -(high.y + margin)});
    text += ' ';
    append(text, room);
    text += "\">\n  <path transform=\"scale(1 -1)\" fill=\"none\" stroke=\"#1f2933\" stroke-width=\"" +
            format_number(0.004 * size) + "\"\n    d=\"";
    return text + path_text(pieces, curve.is_closed()) + "\"/>\n</svg>\n";
}

}  // namespace batten
