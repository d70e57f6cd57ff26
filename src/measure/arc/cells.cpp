#include "measure/arc/cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "batten/base/error.hpp"
#include "measure/arc/runs.hpp"
#include "measure/arc/series.hpp"
#include "num/gauss.hpp"
#include "num/sum.hpp"

namespace batten::arc {
namespace {

/// Below this share of a piece's polygon an error is rounding.
constexpr double rounding = 0x1p-50;
/// Nobody needs to be told less of a piece.
constexpr double loosest = 0x1p-10;
/// What a piece may be wrong by is shared by its cells, of which there are fewer than this but
/// towards a cusp, where most of them have errors far below.
constexpr double cells_expected = 8;
/// Towards a place where the rate is neither smooth nor small.
constexpr int most_halvings = 60;
/// A single place that is not smooth takes some 60 halvings.
constexpr int most_tries = 250;
constexpr double loosened = 0x1p14;
constexpr int rough_nodes = 8;
/// Arc lengths that are worked on side by side.
constexpr std::size_t lanes = 8;

template <std::size_t N>
BATTEN_INLINE void evaluate(std::span<const double> c, const double* x, double* out) {
    Values<N> at, value;
    std::copy_n(x, N, at.begin());
    sums_at<N>(c.data(), c.size(), at, value);
    std::copy_n(value.begin(), N, out);
}

/// out = sum c_k T_k(x), many at once.
BATTEN_CLONES void evaluate_all(std::span<const double> c, std::span<double> x) {
    std::size_t i = 0;
    for (; i + lanes <= x.size(); i += lanes) evaluate<lanes>(c, &x[i], &x[i]);
    for (; i < x.size(); ++i) evaluate<1>(c, &x[i], &x[i]);
}

double between(double x, Interval part) {
    return std::fmin(std::fmax(x, part.lo), part.hi);
}

}  // namespace

/// Cells as they come, their lengths in units of the rate.
struct Cells::Built {
    std::vector<double> lengths, t;  ///< of the cells, and where they end
    std::vector<Sum> forward, inverse;
    std::vector<double> coefficients;
    num::Sum error;
    int tries = 0;  ///< halvings left before less is asked for

    explicit Built(std::size_t pieces) {
        for (auto* numbers : {&lengths, &t}) numbers->reserve(pieces);
        for (auto* sums : {&forward, &inverse}) sums->reserve(pieces);
        coefficients.reserve(2 * most_terms * pieces);
    }

    void keep(const Cell& cell, double end) {
        const auto kept = [this](const double* c, std::size_t terms) {
            const auto start = static_cast<std::uint32_t>(coefficients.size());
            coefficients.insert(coefficients.end(), c, c + terms);
            return Sum{start, static_cast<std::uint32_t>(terms)};
        };
        forward.push_back(kept(cell.forward, cell.forward_terms));
        inverse.push_back(kept(cell.inverse, cell.inverse_terms));
        lengths.push_back(cell.length);
        error.add(cell.error);
        t.push_back(end);
    }

    /// `t_of` says the parameter at w.
    void add(const Rate& rate, Interval w, const Allowed& allowed, const auto& t_of,
             int halvings = 0) {
        std::optional<Cell> cell = cell_over(rate, w, allowed);
        // A rate that is not known so well, beside a cusp, would be halved without end.
        if (!cell && --tries < 0) {
            cell = cell_over(rate, w, {loosened * allowed.length, loosened * allowed.place});
            if (!cell && tries < -most_tries) cell = even_cell_over(rate, w);
        }
        if (cell || halvings == most_halvings) {
            keep(cell.value_or(standstill()), t_of(w.hi));
            return;
        }
        add(rate, {w.lo, w.middle()}, allowed, t_of, halvings + 1);
        add(rate, {w.middle(), w.hi}, allowed, t_of, halvings + 1);
    }

    /// Up to `end` nothing is added up.
    void add_rest(double end) { keep(standstill(), end); }

    static Cell standstill() {
        Cell cell;
        cell.forward_terms = cell.inverse_terms = 1;
        cell.forward[0] = cell.inverse[0] = 0;
        return cell;
    }
};

Cells::Cells(std::span<const double> joints, const Rate& rate, double tolerance) {
    double rough = 0;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const Interval part{joints[i], joints[i + 1]};
        rough += num::integrate(
            [&](double t) {
                double value;
                rate({&t, 1}, {&value, 1});
                return value;
            },
            part, num::gauss_legendre(rough_nodes));
    }
    const double each = tolerance * rough / static_cast<double>(joints.size());
    const Allowed allowed{std::fmax(each, rounding * rough), std::fmax(each, rounding * rough)};
    Built built(joints.size());
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        built.tries = most_tries;
        built.add(rate, {joints[i], joints[i + 1]}, allowed, [](double t) { return t; });
    }
    take(std::move(built), joints.front(), [](double s) { return s; });
}

Cells::Cells(const Rate& rate, Interval t, const Share& share) {
    const double wrong = std::fmin(share.tolerance, loosest) * share.length;
    const double least = std::fmax(rounding * share.length, share.nothing);
    Built built(1);
    built.tries = most_tries;
    built.add(rate, {0, 1},
              {std::fmax(wrong / cells_expected, least), std::fmax(wrong / 4, least)},
              [&](double w) { return w == 1 ? t.hi : t.lo + w * t.length(); });
    take(std::move(built), t.lo, [](double s) { return s; });
}

Cells::Cells(const Curve& curve, Tolerance tolerance) {
    bezier::require_tolerance(tolerance);
    const bezier::Pieces pieces(curve);
    const std::vector<bezier::Stretch> stretches = bezier::stretches(pieces);
    if (stretches.empty()) {
        throw Error("curve.no-length", "curve", "0", "the curve must not be a single point");
    }
    std::vector<chebyshev::Basis> bases;
    for (int degree = 0; degree < pieces.degree(); ++degree) {
        bases.emplace_back(static_cast<std::size_t>(degree));
    }
    std::vector<double> polygons(pieces.size());
    double polygon = 0, longest = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        polygons[i] = bezier::polygon_length(pieces, i);
        polygon += polygons[i];
        longest = std::fmax(longest, polygons[i]);
    }
    const double wanted =
        tolerance.is_relative ? tolerance.value : pieces.in_normal(tolerance) / polygon;
    // A polygon is longer than its curve, by little: once is mostly enough.
    for (double share = std::fmin(wanted, loosest);; share /= 8) {
        Built built(pieces.size());
        std::size_t next = 0;
        for (const bezier::Stretch& stretch : stretches) {
            for (; next < stretch.piece; ++next) built.add_rest(pieces.part(next).hi);
            next = stretch.piece + 1;
            const double piece = polygons[stretch.piece];
            const Allowed allowed{std::fmax(share / cells_expected, rounding) * piece,
                                  std::fmax(share / 4, rounding) * piece};
            built.tries = most_tries;
            built.add(speed_of(stretch, bases), {0, 1}, allowed, [&](double w) {
                return pieces.t_of(stretch.piece, stretch.u_of(w));
            });
        }
        for (; next < pieces.size(); ++next) built.add_rest(pieces.part(next).hi);
        take(std::move(built), pieces.part(0).lo, [&](double s) { return pieces.in_data(s, 1); });
        const double limit = tolerance.is_relative ? wanted * length() : tolerance.value;
        const double place_error = pieces.in_data(share / 4 * longest, 1);
        if (error_ + place_error <= limit || share < rounding) return;
    }
}

template <class InData>
void Cells::take(Built built, double start, InData in_data) {
    s_.assign(1, 0);
    t_.assign(1, start);
    num::Sum s;
    for (const double length : built.lengths) {
        s.add(length);
        s_.push_back(in_data(s.value()));
    }
    t_.insert(t_.end(), built.t.begin(), built.t.end());
    forward_ = std::move(built.forward);
    inverse_ = std::move(built.inverse);
    coefficients_ = std::move(built.coefficients);
    error_ = in_data(built.error.value() + rounding * s.value());
}

std::size_t Cells::cell_at_t(double t) const { return interval_of(t_, t); }

double Cells::t_at(double s) const {
    double t;
    t_at({&s, 1}, {&t, 1});
    return t;
}

void Cells::t_at(std::span<const double> s, std::span<double> t) const {
    for_runs(s_, s, [&](std::size_t cell, std::size_t first, std::size_t count) {
        t_in(cell, s.subspan(first, count), t.subspan(first, count));
    });
}

double Cells::s_in(std::size_t cell, double t) const {
    const Interval part = this->t(cell), arc = s(cell);
    double x = 2 * ((t - part.lo) / part.length()) - 1;
    evaluate_all(terms_of(forward_[cell]), {&x, 1});
    return t <= part.lo ? arc.lo : t >= part.hi ? arc.hi : between(arc.lo + arc.length() * x, arc);
}

void Cells::t_in(std::size_t cell, std::span<const double> s, std::span<double> t) const {
    const Interval part = this->t(cell), arc = this->s(cell);
    if (arc.length() == 0) {
        std::fill(t.begin(), t.end(), part.lo);
        return;
    }
    const double scale = 2 / arc.length();
    for (std::size_t i = 0; i < s.size(); ++i) t[i] = (s[i] - arc.lo) * scale - 1;
    evaluate_all(terms_of(inverse_[cell]), t);
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double at = between(part.lo + part.length() * t[i], part);
        t[i] = s[i] <= arc.lo ? part.lo : s[i] >= arc.hi ? part.hi : at;
    }
}

}  // namespace batten::arc
