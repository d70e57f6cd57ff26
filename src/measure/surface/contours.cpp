#include "batten/measure/contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "batten/base/error.hpp"
#include "measure/surface/chains.hpp"
#include "measure/surface/line_pieces.hpp"
#include "num/roots.hpp"
#include "shape/surface/sheet.hpp"

namespace batten {
namespace {

using contouring::Chain;
using contouring::CubicEnds;
using contouring::LatticeEdge;
using contouring::LinePiece;
using contouring::LinePoint;
using surfaces::Sheet;
using surfaces::SheetColumn;
using surfaces::SheetLine;

constexpr std::size_t cells_a_piece = 8;
constexpr std::size_t least_cells = 64;
constexpr int most_halvings = 8;

/// Every one of `count` pieces is cut into as many cells.
std::size_t cells_of_each(std::size_t count) {
    return std::max(cells_a_piece, (least_cells + count - 1) / count);
}

std::vector<SheetLine> lattice_lines(const Sheet& sheet) {
    const std::size_t count = sheet.intervals().size();
    return sheet.lines(std::vector<std::size_t>(count, cells_of_each(count)));
}

std::vector<double> lattice_rows(const Sheet& sheet) {
    const std::vector<double> strips = sheet.strips();
    const std::size_t each = cells_of_each(strips.size() - 1);
    std::vector<double> rows;
    for (std::size_t p = 0; p + 1 < strips.size(); ++p) {
        const Interval strip{strips[p], strips[p + 1]};
        for (std::size_t k = 0; k < each; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(each);
            rows.push_back(strip.lo + share * strip.length());
        }
    }
    rows.push_back(strips.back());
    return rows;
}

/// Where a level crosses an edge of the lattice.
struct Crossing {
    double x = 0, y = 0;
    LatticeEdge edge;
};

/// One level of one surface, on one lattice.
class Tracer {
public:
    Tracer(const Sheet& sheet, double level, double tolerance)
        : sheet_(sheet), level_(level), tolerance_(tolerance), lines_(lattice_lines(sheet)),
          rows_(lattice_rows(sheet)) {
        for (const double y : rows_) knots_.push_back(sheet_.knots(y));
    }

    std::vector<Contour> trace() const {
        Grid above = sheet_.heights(lines_, rows_);
        const Grid middles = heights_in_middles();
        for (std::size_t i = 0; i < above.nu(); ++i) {
            for (std::size_t j = 0; j < above.nv(); ++j) {
                above(i, j) = above(i, j) >= level_ ? 1 : 0;
            }
        }
        std::vector<Contour> result;
        for (const Chain& chain : contouring::chains_of(above, middles)) {
            std::vector<LinePiece> pieces = refined(pieces_of(chain));
            if (pieces.empty()) continue;
            if (sheet_.is_transposed()) exchange(pieces);
            result.push_back({level_, curve_of(pieces, chain.is_closed)});
        }
        return result;
    }

private:
    SheetColumn column(std::size_t c) const { return Sheet::column_after(lines_[c]); }

    /// In the middle of cells less the level.
    Grid heights_in_middles() const {
        Grid middles(lines_.size() - 1, rows_.size() - 1);
        std::vector<double> y;
        for (std::size_t j = 0; j + 1 < rows_.size(); ++j) {
            y.push_back(Interval{rows_[j], rows_[j + 1]}.middle());
        }
        std::vector<SheetLine> between;
        for (std::size_t c = 0; c + 1 < lines_.size(); ++c) {
            const SheetLine &line = lines_[c], &next = lines_[c + 1];
            const double end = next.interval == line.interval ? next.share : 1;
            between.push_back({line.interval, 0.5 * (line.share + end)});
        }
        const Grid plain = sheet_.heights(between, y), sides = sheet_.heights(lines_, y);
        for (std::size_t c = 0; c < middles.nu(); ++c) {
            for (std::size_t j = 0; j < middles.nv(); ++j) {
                const double z = column(c).is_wall ? 0.5 * (sides(c, j) + sides(c + 1, j))
                                                   : plain(c, j);
                middles(c, j) = z - level_;
            }
        }
        return middles;
    }

    double place(std::size_t line, double y) const {
        return Sheet::place(lines_[line], sheet_.knots(y));
    }

    LinePoint point_at(std::size_t interval, double x, double y) const {
        const HeightJet jet = sheet_.jet_in(interval, x, y);
        const double slope = std::hypot(jet.x, jet.y);
        if (!(slope > 0)) return {x, y, 0, 0};
        return {x, y, jet.y / slope, -jet.x / slope};
    }

    /// On a wall lines run along it; which way is told by the heights beside.
    LinePoint point_on_wall(std::size_t c, double x, double y) const {
        const Interval domain = sheet_.domain().y;
        const double step = 1e-5 * domain.length();
        const double lo = domain.clamp(y - step), hi = domain.clamp(y + step);
        const double dx = place(c, hi) - place(c, lo), dy = hi - lo, length = std::hypot(dx, dy);
        const bool rises = sheet_.value_in(lines_[c + 1].interval, x, y) >
                           sheet_.value_in(lines_[c].interval, x, y);
        const double sign = rises ? -1 : 1;  // the higher ground on the left
        return {x, y, sign * dx / length, sign * dy / length};
    }

    LinePoint point_in(std::size_t c, double x, double y) const {
        return column(c).is_wall ? point_on_wall(c, x, y) : point_at(lines_[c].interval, x, y);
    }

    /// Where the level crosses an edge: its ends differ in sign.
    Crossing crossing(const LatticeEdge& edge) const {
        const std::vector<double>& at = knots_[edge.j];
        const double x = Sheet::place(lines_[edge.i], at), y = rows_[edge.j];
        if (edge.is_along_x) {
            const Interval range{x, Sheet::place(lines_[edge.i + 1], at)};
            if (!(range.lo < range.hi)) return {x, y, edge};
            const std::size_t interval = lines_[edge.i].interval;
            const auto height = [&](double t) { return sheet_.value_in(interval, t, y); };
            return {root(height, range), y, edge};
        }
        const auto height = [&](double t) {
            const std::vector<double> knots = sheet_.knots(t);
            return sheet_.value_in(Sheet::home_of(lines_, edge.i, knots),
                                   Sheet::place(lines_[edge.i], knots), t);
        };
        const double t = root(height, {y, rows_[edge.j + 1]});
        return {place(edge.i, t), t, edge};
    }

    template <class Height>
    double root(const Height& height_of, Interval range) const {
        const auto height = [&](double t) { return height_of(t) - level_; };
        const double lo = height(range.lo), hi = height(range.hi);
        if (lo == 0) return range.lo;
        if (hi == 0) return range.hi;
        // Rounding may see one side of a knot line above, the other below the level.
        if ((lo > 0) == (hi > 0)) return std::fabs(lo) < std::fabs(hi) ? range.lo : range.hi;
        return num::find_root(height, range).at;
    }

    /// The column that holds what is between two crossings that follow one another.
    static std::size_t column_of(const LatticeEdge& a, const LatticeEdge& b) {
        if (a.is_along_x) return a.i;
        return b.is_along_x ? b.i : std::min(a.i, b.i);
    }

    /// Between crossings in a line, those at one place once, higher ground on the left.
    std::vector<LinePiece> pieces_of(const Chain& chain) const {
        std::vector<Crossing> points;
        for (const LatticeEdge& edge : chain.edges) points.push_back(crossing(edge));
        if (chain.is_closed && points.size() > 2) points.push_back(points.front());
        std::vector<LinePiece> pieces;
        double along = 0;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const std::size_t c = column_of(points[i].edge, points[i + 1].edge);
            const bool is_end = i + 2 == points.size();
            const bool is_short = std::hypot(points[i + 1].x - points[i].x,
                                             points[i + 1].y - points[i].y) <= 1e-3 * tolerance_;
            if (is_short) {
                Crossing& next = points[i + 1];
                if (is_end && !pieces.empty()) pieces.back().end_at(next.x, next.y);
                else next = {points[i].x, points[i].y, next.edge};
                continue;
            }
            const LinePoint a = point_in(c, points[i].x, points[i].y);
            const LinePoint b = point_in(c, points[i + 1].x, points[i + 1].y);
            along += (b.x - a.x) * (a.dx + b.dx) + (b.y - a.y) * (a.dy + b.dy);
            pieces.push_back({a, b, c});
        }
        if (along < 0) reverse(pieces);
        return pieces;
    }

    /// On the level beside (x, y), by Newton steps along the slope.
    LinePoint projected(std::size_t c, double x, double y) const {
        if (column(c).is_wall) return point_on_wall(c, place(c, y), y);
        const std::size_t interval = lines_[c].interval;
        const Rectangle domain = sheet_.domain();
        for (int step = 0; step < 20; ++step) {
            const HeightJet jet = sheet_.jet_in(interval, x, y);
            const double slope_sq = jet.x * jet.x + jet.y * jet.y;
            if (!(slope_sq > 0)) break;
            const double share = (level_ - jet.value) / slope_sq;
            x = domain.x.clamp(x + share * jet.x);
            y = domain.y.clamp(y + share * jet.y);
            if (std::fabs(share) * std::sqrt(slope_sq) <= 1e-9 * tolerance_) break;
        }
        return point_at(interval, x, y);
    }

    std::vector<LinePiece> refined(const std::vector<LinePiece>& pieces) const {
        std::vector<LinePiece> result;
        for (const LinePiece& piece : pieces) refine(piece, most_halvings, result);
        return result;
    }

    double distance_to_level(std::size_t c, double x, double y) const {
        if (column(c).is_wall) return std::fabs(x - place(c, y));
        const HeightJet jet = sheet_.jet_in(lines_[c].interval, x, y);
        const double slope = std::hypot(jet.x, jet.y), gap = std::fabs(jet.value - level_);
        return slope > 0 ? gap / slope : gap > 0 ? tolerance_ : 0;
    }

    /// How far the cubic between is from the level, in data units.
    double farthest_from_level(const LinePiece& piece, const CubicEnds& d) const {
        double farthest = 0;
        for (const double u : {0.25, 0.5, 0.75}) {
            const std::array<double, 2> p = on_cubic(piece.a, piece.b, d, u);
            farthest = std::max(farthest, distance_to_level(piece.column, p[0], p[1]));
        }
        return farthest;
    }

    /// Puts points between until the cubic between is close to the level.
    void refine(const LinePiece& piece, int halvings, std::vector<LinePiece>& out) const {
        const LinePoint &a = piece.a, &b = piece.b;
        const CubicEnds d = ends_of(a, b);
        if (farthest_from_level(piece, d) <= 0.5 * tolerance_ || halvings == 0) {
            out.push_back(piece);
            return;
        }
        const std::array<double, 2> p = on_cubic(a, b, d, 0.5);
        const LinePoint middle = projected(piece.column, p[0], p[1]);
        const double chord = std::hypot(b.x - a.x, b.y - a.y);
        const double left = std::hypot(middle.x - a.x, middle.y - a.y);
        const double right = std::hypot(b.x - middle.x, b.y - middle.y);
        if (std::min(left, right) < 0.1 * chord || std::max(left, right) > chord) {
            out.push_back(piece);
            return;
        }
        refine({a, middle, piece.column}, halvings - 1, out);
        refine({middle, b, piece.column}, halvings - 1, out);
    }

    const Sheet& sheet_;
    double level_, tolerance_;
    std::vector<SheetLine> lines_;
    std::vector<double> rows_;
    std::vector<std::vector<double>> knots_;
};

}  // namespace

std::vector<Contour> contours(const Surface& surface, double level, Tolerance tolerance) {
    const Sheet sheet(surface);
    if (sheet.degree() == 0) {
        throw Error("surface.degree", "surface", "degree 0",
                    "a surface of steps has no lines of equal height");
    }
    const Rectangle domain = sheet.domain();
    const double extent = std::max(domain.x.length(), domain.y.length());
    return Tracer(sheet, level, tolerance.in_units(extent)).trace();
}

std::vector<double> round_levels(const Surface& surface, int count) {
    const Sheet sheet(surface);
    const Grid z = sheet.heights(lattice_lines(sheet), lattice_rows(sheet));
    const std::span<const double> values = z.view().values();
    const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
    return round_levels(Interval{*lo, *hi}, count);
}

std::vector<double> round_levels(Interval heights, int count) {
    const double rounding = 1e-12 * std::max(std::fabs(heights.lo), std::fabs(heights.hi));
    if (!(heights.length() > rounding)) return {};
    const double rough = heights.length() / (count + 1);
    double step = std::pow(10, std::floor(std::log10(rough)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * step <= rough) {
            step *= factor;
            break;
        }
    }
    std::vector<double> levels;
    for (double k = std::floor(heights.lo / step) + 1; k * step < heights.hi; ++k) {
        levels.push_back(k * step);
    }
    return levels;
}

}  // namespace batten
