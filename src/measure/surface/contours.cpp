#include "batten/measure/contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "batten/base/error.hpp"
#include "measure/surface/level_lattice.hpp"
#include "measure/surface/line_pieces.hpp"
#include "shape/surface/sheet.hpp"

namespace batten {
namespace {

using contouring::CubicEnds;
using contouring::LevelLattice;
using contouring::LinePiece;
using contouring::LinePoint;
using contouring::Thread;
using surfaces::Sheet;

constexpr int most_halvings = 8;

/// Curves through the crossings of one level, close to it between them.
class Tracer {
public:
    Tracer(const Sheet& sheet, double level, double tolerance)
        : sheet_(sheet), level_(level), tolerance_(tolerance), lattice_(sheet, level, tolerance) {}

    std::vector<Contour> trace() const {
        std::vector<Contour> result;
        for (Thread& thread : lattice_.threads()) {
            const bool is_closed = thread.is_closed;
            Refined line = refined(pieces_of(std::move(thread)));
            if (line.pieces.empty()) continue;
            if (sheet_.is_transposed()) exchange(line.pieces);
            const bool is_met = lattice_.is_certain() && line.is_close;
            result.push_back({level_, curve_of(line.pieces, is_closed),
                              is_met ? Status::met : Status::not_met});
        }
        return result;
    }

private:
    struct Refined {
        std::vector<LinePiece> pieces;
        bool is_close = true;
    };

    /// Those between points at one place left out, higher ground on the left.
    std::vector<LinePiece> pieces_of(Thread thread) const {
        std::vector<LinePiece> pieces;
        double along = 0;
        for (std::size_t i = 0; i < thread.pieces.size(); ++i) {
            LinePiece& piece = thread.pieces[i];
            const LinePoint &a = piece.a, &b = piece.b;
            const bool is_end = i + 1 == thread.pieces.size();
            if (std::hypot(b.x - a.x, b.y - a.y) <= 1e-3 * tolerance_) {
                if (!is_end) thread.pieces[i + 1].start_at(a.x, a.y);
                else if (!pieces.empty()) pieces.back().end_at(b.x, b.y);
                continue;
            }
            along += (b.x - a.x) * (a.dx + b.dx) + (b.y - a.y) * (a.dy + b.dy);
            pieces.push_back(piece);
        }
        if (along < 0) reverse(pieces);
        return pieces;
    }

    /// On the level beside (x, y), by Newton steps along the slope.
    LinePoint projected(std::size_t c, double x, double y) const {
        if (lattice_.column(c).is_wall) return lattice_.point_in(c, lattice_.place(c, y), y);
        const std::size_t interval = lattice_.interval(c);
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
        return lattice_.point_in(c, x, y);
    }

    Refined refined(const std::vector<LinePiece>& pieces) const {
        Refined result;
        for (const LinePiece& piece : pieces) refine(piece, most_halvings, result);
        return result;
    }

    /// Along the slope, and where that vanishes as the surface bends; what rounding leaves of the
    /// height is no distance.
    double distance_to_level(std::size_t c, double x, double y) const {
        if (lattice_.column(c).is_wall) return std::fabs(x - lattice_.place(c, y));
        const HeightJet jet = sheet_.jet_in(lattice_.interval(c), x, y);
        const double gap = std::fabs(jet.value - level_) - lattice_.noise();
        if (!(gap > 0)) return 0;
        const double slope = std::hypot(jet.x, jet.y);
        const double bend = std::hypot(jet.xx, jet.xy, jet.yy);
        return 2 * gap / (slope + std::sqrt(slope * slope + 2 * bend * gap));
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
    void refine(const LinePiece& piece, int halvings, Refined& out) const {
        const LinePoint &a = piece.a, &b = piece.b;
        const CubicEnds d = ends_of(a, b);
        const double chord = std::hypot(b.x - a.x, b.y - a.y);
        const double farthest = farthest_from_level(piece, d);
        if (farthest <= 0.5 * tolerance_) return out.pieces.push_back(piece);
        const std::array<double, 2> p = on_cubic(a, b, d, 0.5);
        const LinePoint middle = projected(piece.column, p[0], p[1]);
        const double left = std::hypot(middle.x - a.x, middle.y - a.y);
        const double right = std::hypot(b.x - middle.x, b.y - middle.y);
        if (halvings == 0 || std::min(left, right) < 0.1 * chord || std::max(left, right) > chord) {
            out.is_close = out.is_close && farthest <= tolerance_;
            return out.pieces.push_back(piece);
        }
        refine({a, middle, piece.column}, halvings - 1, out);
        refine({middle, b, piece.column}, halvings - 1, out);
    }

    const Sheet& sheet_;
    double level_, tolerance_;
    LevelLattice lattice_;
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
    const Grid z = contouring::lattice_of(sheet).heights(sheet);
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
