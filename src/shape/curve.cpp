#include "batten/shape/curve.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten {
namespace {

/// A curve restricted to a part of its domain.
struct TrimmedCurve {
    Curve whole;
    std::vector<double> joints;
    std::size_t first_piece;

    int dim() const { return whole.dim(); }
    std::span<const double> breaks() const { return joints; }
    bool is_closed() const { return false; }
    std::optional<int> degree() const { return whole.degree(); }
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const {
        whole.jets_on(first_piece + piece, t, order, out);
    }
};

}  // namespace

std::size_t Curve::piece_of(double t) const {
    const std::span<const double> joints = breaks();
    const auto inner = joints.subspan(1, joints.size() - 2);
    return static_cast<std::size_t>(std::upper_bound(inner.begin(), inner.end(), t) -
                                    inner.begin());
}

Jet Curve::jet_on(std::size_t piece, double t, int order) const {
    Jet result(dim(), order);
    jets_on(piece, {&t, 1}, order, result.values());
    return result;
}

void Curve::jets(std::span<const double> t, int order, std::span<double> out) const {
    if (model_->jets(t, order, out)) return;
    const std::size_t width = static_cast<std::size_t>((order + 1) * dim());
    std::size_t first = 0;
    while (first < t.size()) {
        const std::size_t piece = piece_of(t[first]);
        const bool is_first = piece == 0, is_last = piece + 1 == pieces();
        const auto [lo, hi] = this->piece(piece);
        std::size_t last = first + 1;
        while (last < t.size() && (is_first || t[last] >= lo) && (is_last || t[last] < hi)) ++last;
        jets_on(piece, t.subspan(first, last - first), order,
                out.subspan(first * width, (last - first) * width));
        first = last;
    }
}

std::vector<double> Curve::operator()(double t) const {
    std::vector<double> point(static_cast<std::size_t>(dim()));
    jets_on(piece_of(t), {&t, 1}, 0, point);
    return point;
}

void CallableCurve::jets_on(std::size_t piece, std::span<const double> t, int order,
                            std::span<double> out) const {
    const double lo = joints[piece], hi = joints[piece + 1];
    const double inner_lo = piece == 0 ? lo : std::nextafter(lo, hi);
    const double inner_hi = piece + 2 == joints.size() ? hi : std::nextafter(hi, lo);
    const std::size_t width = static_cast<std::size_t>((order + 1) * dimension);
    for (std::size_t i = 0; i < t.size(); ++i) {
        function(std::clamp(t[i], inner_lo, inner_hi), order, out.subspan(i * width, width));
    }
}

double extent(const Curve& curve) {
    Points corners(0, curve.dim());
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const Interval piece = curve.piece(i);
        for (const double t : {piece.lo, piece.middle(), piece.hi}) {
            corners.push_back(curve.jet_on(i, t, 0)[0]);
        }
    }
    return extent(corners.view());
}

Curve trimmed(const Curve& curve, Interval part) {
    const Interval domain = curve.domain();
    for (const double t : {part.lo, part.hi}) {
        if (!domain.contains(t)) {
            throw Error("curve.outside", "part", format_number(t),
                        "must lie in the curve's domain [" + format_number(domain.lo) + ", " +
                            format_number(domain.hi) + "]");
        }
    }
    if (!(part.lo < part.hi)) {
        throw Error("curve.part-empty", "part",
                    format_number(part.lo) + "," + format_number(part.hi),
                    "the second parameter must be larger than the first");
    }
    if (part == domain) return curve;
    TrimmedCurve result{curve, {part.lo}, curve.piece_of(part.lo)};
    for (const double joint : curve.breaks()) {
        if (joint > part.lo && joint < part.hi) result.joints.push_back(joint);
    }
    result.joints.push_back(part.hi);
    return result;
}

}  // namespace batten
