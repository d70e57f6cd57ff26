#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/svg_arcs.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/spline_graph.hpp"
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

/// The smallest upright box round something.
struct Box {
    Point low, high;

    explicit Box(Point p) : low(p), high(p) {}
    void add(Point p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
};

Box box_of(const std::vector<Piece>& pieces) {
    Box box(pieces.front().start());
    for (const Piece& piece : pieces) {
        for (int i = 0; i <= piece.degree; ++i) {
            box.add(piece.points[static_cast<std::size_t>(i)]);
        }
    }
    return box;
}

/// Round the joints and the places where the tangent is level or upright.
Box box_of(const ArcChain& chain) {
    constexpr double quarter = std::numbers::pi / 2;
    Box box({chain.joints()(0, 0), chain.joints()(0, 1)});
    for (std::size_t i = 0; i < chain.arcs(); ++i) {
        const Arc arc = chain.arc(i);
        box.add({arc.end[0], arc.end[1]});
        if (arc.is_line()) continue;
        const double start = std::atan2(arc.start_tangent()[1], arc.start_tangent()[0]);
        const double low = std::min(start, start + arc.sweep()), high = low + std::fabs(arc.sweep());
        for (double turns = std::ceil(low / quarter); turns * quarter < high; ++turns) {
            const double share = (turns * quarter - start) / arc.sweep();
            const double t = chain.breaks()[i] + share * arc.length();
            std::array<double, 2> p{};
            chain.jets_on(i, {&t, 1}, 0, p);
            box.add({p[0], p[1]});
        }
    }
    return box;
}

std::string picture_of(const std::string& path, const Box& box) {
    const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    const double margin = 0.04 * size;
    const Point room = box.high - box.low + Point{2 * margin, 2 * margin};
    if (!std::isfinite(room.x) || !std::isfinite(room.y)) {
        throw Error("number.overflow", "extent", "beyond a double",
                    "results must lie within the range of a double");
    }
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
    append(text, {box.low.x - margin, -(box.high.y + margin)});
    text += ' ';
    append(text, room);
    text += "\">\n  <path transform=\"scale(1 -1)\" fill=\"none\" stroke=\"#1f2933\" stroke-width=\"" +
            format_number(0.004 * size) + "\"\n    d=\"";
    return text + path + "\"/>\n</svg>\n";
}

}  // namespace

std::string svg_path(const Curve& curve) {
    if (const ArcChain* chain = curve.shape<ArcChain>()) return svg_path(*chain);
    return path_text(beziers(curve), curve.is_closed());
}

std::string svg_picture(const Curve& curve) {
    if (const ArcChain* chain = curve.shape<ArcChain>()) {
        return picture_of(svg_path(*chain), box_of(*chain));
    }
    std::string path;
    std::vector<Piece> all;
    for (const Curve& part : parts_between_jumps(curve)) {
        const std::vector<Piece> pieces = beziers(part);
        path += (path.empty() ? "" : " ") + path_text(pieces, part.is_closed());
        all.insert(all.end(), pieces.begin(), pieces.end());
    }
    return picture_of(path, box_of(all));
}

}  // namespace batten
