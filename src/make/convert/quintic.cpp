#include <array>
#include <cmath>

#include "batten/make/convert.hpp"
#include "make/convert/halving.hpp"

namespace batten {
namespace {

/// Of the larger of two derivatives: what rounding makes of one.
constexpr double same_derivative = 1e-9;

using ControlPoint = std::vector<double>;
/// The six Bezier points of a piece.
using QuinticPiece = std::array<ControlPoint, 6>;

/// The piece with the value and two derivatives of `curve` at both ends of `part`.
QuinticPiece quintic_piece(const Curve& curve, std::size_t piece, Interval part) {
    const Jet start = curve.jet_on(piece, part.lo, 2), end = curve.jet_on(piece, part.hi, 2);
    const double h = part.length();
    QuinticPiece p;
    p.fill(ControlPoint(static_cast<std::size_t>(curve.dim())));
    for (std::size_t k = 0; k < p[0].size(); ++k) {
        p[0][k] = start[0][k];
        p[1][k] = start[0][k] + h * start[1][k] / 5;
        p[2][k] = start[0][k] + h * (2 * start[1][k] / 5 + h * start[2][k] / 20);
        p[3][k] = end[0][k] - h * (2 * end[1][k] / 5 - h * end[2][k] / 20);
        p[4][k] = end[0][k] - h * end[1][k] / 5;
        p[5][k] = end[0][k];
    }
    return p;
}

ControlPoint mixed(const ControlPoint& a, const ControlPoint& b, double share) {
    ControlPoint p(a.size());
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = a[k] + share * (b[k] - a[k]);
    return p;
}

/// de Casteljau.
ControlPoint value_of(QuinticPiece p, double share) {
    for (std::size_t top = 5; top > 0; --top) {
        for (std::size_t i = 0; i < top; ++i) p[i] = mixed(p[i], p[i + 1], share);
    }
    return p[0];
}

bool agree(std::span<const double> a, std::span<const double> b) {
    double off_sq = 0, size_sq = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        off_sq += (a[k] - b[k]) * (a[k] - b[k]);
        size_sq += a[k] * a[k] + b[k] * b[k];
    }
    return off_sq <= same_derivative * same_derivative * size_sq;
}

/// A piece and where it lies.
struct Placed {
    QuinticPiece points;
    Interval part;
    Jet start, end;  ///< to the second derivative
};

/// What a knot between two pieces adds to the row of control points.
class QuinticRow {
public:
    explicit QuinticRow(int dim) : points_(0, dim) {}

    void add(const ControlPoint& point) { points_.push_back(point); }
    void knot(double at, std::size_t times) { knots_.insert(knots_.end(), times, at); }
    /// The knot between two pieces: three times where derivatives agree, else five times.
    bool is_smooth(const Placed& left, const Placed& right) const {
        return agree(left.end[1], right.start[1]) && agree(left.end[2], right.start[2]);
    }
    void joint(const Placed& left, const Placed& right) {
        add(left.points[3]);
        if (is_smooth(left, right)) {
            // Its argument is one knot before, three at and one after the joint.
            const double share = 1 + right.part.length() / left.part.length();
            add(mixed(left.points[3], left.points[4], share));
        } else {
            for (const std::size_t k : {4u, 5u}) add(left.points[k]);
            add(right.points[1]);
        }
        add(right.points[2]);
    }

    std::vector<double> knots_;
    Points points_;
};

BSplineCurve open_quintic(const std::vector<Placed>& pieces, int dim) {
    QuinticRow row(dim);
    row.knot(pieces.front().part.lo, 6);
    for (std::size_t k = 0; k < 3; ++k) row.add(pieces.front().points[k]);
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
        row.knot(pieces[i].part.hi, row.is_smooth(pieces[i], pieces[i + 1]) ? 3 : 5);
        row.joint(pieces[i], pieces[i + 1]);
    }
    row.knot(pieces.back().part.hi, 6);
    for (std::size_t k = 3; k < 6; ++k) row.add(pieces.back().points[k]);
    return {BSplineBasis(row.knots_, 5), row.points_};
}

/// The row starts after the first knot's own points and ends with them: its point i has the
/// arguments of the period's knots i + 1 ... i + 5. A periodic basis counts from 5 knots before the
/// last of the start.
BSplineCurve closed_quintic(const std::vector<Placed>& pieces, int dim) {
    QuinticRow row(dim);
    const Placed &first = pieces.front(), &last = pieces.back();
    const bool is_smooth = row.is_smooth(last, first);
    const std::size_t times = is_smooth ? 3 : 5;
    row.knot(first.part.lo, times);
    if (!is_smooth) {
        for (const std::size_t k : {1u, 2u}) row.add(first.points[k]);
    }
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
        row.knot(pieces[i].part.hi, row.is_smooth(pieces[i], pieces[i + 1]) ? 3 : 5);
        row.joint(pieces[i], pieces[i + 1]);
    }
    if (is_smooth) {
        row.joint(last, first);
    } else {
        for (const std::size_t k : {3u, 4u, 5u}) row.add(last.points[k]);
    }
    row.knot(last.part.hi, 1);
    const std::size_t count = row.points_.size();
    Points points(0, dim);
    const std::size_t back = 6 - times;
    for (std::size_t j = 0; j < count; ++j) {
        points.push_back(row.points_[(j + back * (count - 1)) % count]);
    }
    return {BSplineBasis::periodic(row.knots_, 5), points};
}

}  // namespace

BSplineCurve to_quintic(const Curve& curve, double tolerance) {
    const bool is_exact = curve.degree() && *curve.degree() <= 5;
    const std::vector<double> breaks =
        conversion::halved(curve, [&](std::size_t piece, Interval part) {
            if (is_exact) return true;
            const QuinticPiece quintic = quintic_piece(curve, piece, part);
            for (const double share : {0.5, 0.25, 0.75}) {
                const Jet p = curve.jet_on(piece, part.lo + share * part.length(), 0);
                if (conversion::distance(value_of(quintic, share), p[0]) > 0.9 * tolerance) {
                    return false;
                }
            }
            return true;
        });
    std::vector<Placed> pieces;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const Interval part{breaks[i], breaks[i + 1]};
        const std::size_t source = curve.piece_of(part.middle());
        pieces.push_back({quintic_piece(curve, source, part), part,
                          curve.jet_on(source, part.lo, 2), curve.jet_on(source, part.hi, 2)});
    }
    return curve.is_closed() ? closed_quintic(pieces, curve.dim())
                             : open_quintic(pieces, curve.dim());
}

}  // namespace batten
