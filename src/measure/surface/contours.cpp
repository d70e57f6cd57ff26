#include "batten/measure/contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "measure/surface/chains.hpp"
#include "num/roots.hpp"

namespace batten {
namespace {

using contouring::Chain;
using contouring::LatticeEdge;

constexpr std::size_t cells_a_piece = 8;
constexpr std::size_t least_cells = 64;
constexpr int most_halvings = 8;

/// A point of a line and its direction, higher ground on the left; 0, 0 at a summit.
struct LinePoint {
    double x = 0, y = 0;
    double dx = 0, dy = 0;
};

std::vector<double> lattice_lines(const BSplineBasis& basis) {
    const std::size_t pieces = basis.breaks().size() - 1;
    const std::size_t each = std::max(cells_a_piece, (least_cells + pieces - 1) / pieces);
    std::vector<double> lines;
    for (std::size_t p = 0; p < pieces; ++p) {
        const Interval piece{basis.breaks()[p], basis.breaks()[p + 1]};
        for (std::size_t k = 0; k < each; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(each);
            lines.push_back(piece.lo + share * piece.length());
        }
    }
    lines.push_back(basis.breaks().back());
    return lines;
}

std::vector<double> cell_middles(const std::vector<double>& lines) {
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        result.push_back(Interval{lines[i], lines[i + 1]}.middle());
    }
    return result;
}

/// One level of one surface, on one lattice.
class Tracer {
public:
    Tracer(const SplineSurface& surface, double level, double tolerance)
        : surface_(surface), level_(level), tolerance_(tolerance),
          x_(lattice_lines(surface.x_basis())), y_(lattice_lines(surface.y_basis())) {}

    std::vector<Contour> trace() const {
        Grid above = surface_.evaluate(x_, y_);
        Grid middles = surface_.evaluate(cell_middles(x_), cell_middles(y_));
        for (std::size_t i = 0; i < above.nu(); ++i) {
            for (std::size_t j = 0; j < above.nv(); ++j) {
                above(i, j) = above(i, j) >= level_ ? 1 : 0;
            }
        }
        for (std::size_t i = 0; i < middles.nu(); ++i) {
            for (std::size_t j = 0; j < middles.nv(); ++j) middles(i, j) -= level_;
        }
        std::vector<Contour> result;
        for (const Chain& chain : contouring::chains_of(above, middles)) {
            const std::vector<LinePoint> points = refined(points_of(chain));
            if (points.size() >= 2) result.push_back({level_, curve_of(points, chain.is_closed)});
        }
        return result;
    }

private:
    LinePoint point_at(double x, double y) const {
        const HeightJet jet = surface_.jet(x, y);
        const double slope = std::hypot(jet.x, jet.y);
        if (!(slope > 0)) return {x, y, 0, 0};
        return {x, y, jet.y / slope, -jet.x / slope};
    }

    /// Where the level crosses an edge: its ends differ in sign.
    LinePoint crossing(const LatticeEdge& edge) const {
        const double x = x_[edge.i], y = y_[edge.j];
        const Interval range = edge.is_along_x ? Interval{x, x_[edge.i + 1]}
                                               : Interval{y, y_[edge.j + 1]};
        const auto height = [&](double t) {
            return (edge.is_along_x ? surface_(t, y) : surface_(x, t)) - level_;
        };
        const double t = height(range.lo) == 0   ? range.lo
                         : height(range.hi) == 0 ? range.hi
                                                 : num::find_root(height, range).at;
        return edge.is_along_x ? point_at(t, y) : point_at(x, t);
    }

    /// Crossings in a line, those at one place once, higher ground on the left.
    std::vector<LinePoint> points_of(const Chain& chain) const {
        std::vector<LinePoint> points;
        const auto add = [&](const LinePoint& p) {
            const bool is_same = !points.empty() && std::hypot(p.x - points.back().x,
                                                               p.y - points.back().y) <=
                                                        1e-3 * tolerance_;
            if (!is_same) points.push_back(p);
        };
        for (const LatticeEdge& edge : chain.edges) add(crossing(edge));
        if (chain.is_closed && points.size() > 2) {
            add(points.front());
            points.back() = points.front();
        }
        double along = 0;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            along += (points[i + 1].x - points[i].x) * (points[i].dx + points[i + 1].dx) +
                     (points[i + 1].y - points[i].y) * (points[i].dy + points[i + 1].dy);
        }
        if (along < 0) std::reverse(points.begin(), points.end());
        return points;
    }

    /// On the level beside (x, y), by Newton steps along the slope.
    LinePoint projected(double x, double y) const {
        const Rectangle domain = surface_.domain();
        for (int step = 0; step < 20; ++step) {
            const HeightJet jet = surface_.jet(x, y);
            const double slope_sq = jet.x * jet.x + jet.y * jet.y;
            if (!(slope_sq > 0)) break;
            const double share = (level_ - jet.value) / slope_sq;
            x = domain.x.clamp(x + share * jet.x);
            y = domain.y.clamp(y + share * jet.y);
            if (std::fabs(share) * std::sqrt(slope_sq) <= 1e-9 * tolerance_) break;
        }
        return point_at(x, y);
    }

    std::vector<LinePoint> refined(const std::vector<LinePoint>& points) const {
        std::vector<LinePoint> result;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            result.push_back(points[i]);
            refine(points[i], points[i + 1], most_halvings, result);
        }
        if (!points.empty()) result.push_back(points.back());
        return result;
    }

    /// Puts points between `a` and `b` until the cubic between is close to the level.
    void refine(const LinePoint& a, const LinePoint& b, int halvings,
                std::vector<LinePoint>& out) const {
        const std::array<double, 4> d = ends_of(a, b);
        double farthest = 0;
        for (const double u : {0.25, 0.5, 0.75}) {
            const std::array<double, 2> p = on_cubic(a, b, d, u);
            const HeightJet jet = surface_.jet(p[0], p[1]);
            const double slope = std::hypot(jet.x, jet.y);
            const double gap = std::fabs(jet.value - level_);
            farthest = std::max(farthest, slope > 0 ? gap / slope : gap > 0 ? tolerance_ : 0);
        }
        if (farthest <= 0.5 * tolerance_ || halvings == 0) return;
        const std::array<double, 2> p = on_cubic(a, b, d, 0.5);
        const LinePoint middle = projected(p[0], p[1]);
        const double chord = std::hypot(b.x - a.x, b.y - a.y);
        const double left = std::hypot(middle.x - a.x, middle.y - a.y);
        const double right = std::hypot(b.x - middle.x, b.y - middle.y);
        if (std::min(left, right) < 0.1 * chord || std::max(left, right) > chord) return;
        refine(a, middle, halvings - 1, out);
        out.push_back(middle);
        refine(middle, b, halvings - 1, out);
    }

    /// Derivatives at both ends of the piece over [0, 1]: as long as those of the arc that turns
    /// from one direction to the other.
    static std::array<double, 4> ends_of(const LinePoint& a, const LinePoint& b) {
        const double x = b.x - a.x, y = b.y - a.y, chord = std::hypot(x, y);
        const bool has_both = (a.dx != 0 || a.dy != 0) && (b.dx != 0 || b.dy != 0);
        const double cosine = a.dx * b.dx + a.dy * b.dy;
        const bool is_forward = a.dx * x + a.dy * y > 0 && b.dx * x + b.dy * y > 0;
        if (!has_both || !is_forward || !(cosine > 0)) return {x, y, x, y};
        // chord / cos(turn / 4)^2, with cos(turn / 2) = sqrt((1 + cosine) / 2).
        const double length = 2 * chord / (1 + std::sqrt(0.5 * (1 + std::min(1.0, cosine))));
        return {length * a.dx, length * a.dy, length * b.dx, length * b.dy};
    }

    static std::array<double, 2> on_cubic(const LinePoint& a, const LinePoint& b,
                                          const std::array<double, 4>& d, double u) {
        const double v = 1 - u, h0 = v * v * (1 + 2 * u), h1 = u * u * (3 - 2 * u);
        const double g0 = u * v * v, g1 = -u * u * v;
        return {h0 * a.x + h1 * b.x + g0 * d[0] + g1 * d[2],
                h0 * a.y + h1 * b.y + g0 * d[1] + g1 * d[3]};
    }

    Curve curve_of(const std::vector<LinePoint>& line, bool is_closed) const {
        const std::size_t pieces = line.size() - 1;
        Points points(line.size(), 2), start(pieces, 2), end(pieces, 2);
        std::vector<double> breaks{0};
        for (std::size_t i = 0; i < line.size(); ++i) {
            points(i, 0) = line[i].x;
            points(i, 1) = line[i].y;
            if (i == pieces) break;
            const double chord = std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
            const std::array<double, 4> d = ends_of(line[i], line[i + 1]);
            breaks.push_back(breaks.back() + chord);
            for (int k = 0; k < 2; ++k) {
                start(i, k) = d[static_cast<std::size_t>(k)] / chord;
                end(i, k) = d[static_cast<std::size_t>(k) + 2] / chord;
            }
        }
        return PiecewiseCubic::hermite(points, start, end, std::move(breaks), is_closed);
    }

    const SplineSurface& surface_;
    double level_, tolerance_;
    std::vector<double> x_, y_;
};

}  // namespace

std::vector<Contour> contours(const SplineSurface& surface, double level, Tolerance tolerance) {
    if (surface.x_basis().degree() == 0 || surface.y_basis().degree() == 0) {
        throw Error("surface.degree", "surface", "degree 0",
                    "a surface of steps has no lines of equal height");
    }
    const Rectangle domain = surface.domain();
    const double extent = std::max(domain.x.length(), domain.y.length());
    return Tracer(surface, level, tolerance.in_units(extent)).trace();
}

std::vector<double> round_levels(const SplineSurface& surface, int count) {
    const Grid z = surface.evaluate(lattice_lines(surface.x_basis()),
                                    lattice_lines(surface.y_basis()));
    const std::span<const double> values = z.view().values();
    const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
    const double rounding = 1e-12 * std::max(std::fabs(*lo), std::fabs(*hi));
    if (!(*hi - *lo > rounding)) return {};
    const double rough = (*hi - *lo) / (count + 1);
    double step = std::pow(10, std::floor(std::log10(rough)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * step <= rough) {
            step *= factor;
            break;
        }
    }
    std::vector<double> levels;
    for (double k = std::floor(*lo / step) + 1; k * step < *hi; ++k) levels.push_back(k * step);
    return levels;
}

}  // namespace batten
