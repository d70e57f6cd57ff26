#include "make/densify/curve_gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace batten::lagrange {
namespace {

/// |f(s) - p|^2, halved, with its first two derivatives by s.
struct HalfSquare {
    double value = 0, slope = 0, bend = 0;
};

HalfSquare half_square(const CellCurve& curve, std::size_t cell, std::span<const double> p,
                       double s) {
    HalfSquare sum;
    std::array<double, most_coefficients> c;
    const std::size_t count = curve.terms() + 2;
    for (std::size_t k = 0; k < p.size(); ++k) {
        curve.power(cell, static_cast<int>(k), {c.data(), count});
        double f = 0, d = 0, dd = 0;  // f'' / 2
        for (std::size_t j = count; j-- > 0;) {
            dd = dd * s + d;
            d = d * s + f;
            f = f * s + c[j];
        }
        const double off = f - p[k];
        sum.value += 0.5 * off * off;
        sum.slope += off * d;
        sum.bend += d * d + 2 * off * dd;
    }
    return sum;
}

}  // namespace

CellFoot foot_on(const CellCurve& curve, std::size_t cell, std::span<const double> p,
                 double guess) {
    constexpr int most_steps = 12;
    constexpr double placed = 1e-9;  // the distance is then good to its square
    double s = std::clamp(guess, 0.0, 1.0);
    HalfSquare here = half_square(curve, cell, p, s);
    for (int step = 0; step < most_steps; ++step) {
        const double move = here.bend > 0 ? -here.slope / here.bend : (here.slope > 0 ? -0.1 : 0.1);
        double next = std::clamp(s + move, 0.0, 1.0);
        HalfSquare there = half_square(curve, cell, p, next);
        for (int half = 0; half < 8 && there.value > here.value; ++half) {
            next = 0.5 * (s + next);
            there = half_square(curve, cell, p, next);
        }
        if (there.value > here.value) break;
        const bool is_placed = std::fabs(next - s) <= placed;
        s = next;
        here = there;
        if (is_placed) break;
    }
    return {s, std::sqrt(2 * here.value)};
}

double largest_gap(const CellCurve& all, const Match& match, Care care, double enough) {
    constexpr std::size_t most_cells = 32;
    const std::size_t cells = match.last - match.first;
    const std::size_t stride = care == Care::full ? 1 : 1 + cells / most_cells;
    const int places = cells < 16 ? 4 : 1;
    const double width = static_cast<double>(stride) / (static_cast<double>(cells) * places);
    std::vector<double> p(static_cast<std::size_t>(all.dim()));
    double gap = 0, before = 0;
    for (std::size_t k = match.first + stride - 1; k < match.last; k += stride) {
        const std::size_t given = k % all.cells();
        for (int i = 1; i <= places; ++i) {
            const double s = static_cast<double>(i) / places;
            all.point(given, s, p);
            const CellFoot foot = foot_on(match.kept, match.cell, p, before + width);
            // Half a step of the given cell back: on the same cell, so its place is near s.
            const double back_by = 0.5 * width / static_cast<double>(stride);
            const double between = stride == 1 ? 0.5 * (before + foot.s) : foot.s - back_by;
            match.kept.point(match.cell, between, p);
            const CellFoot back = foot_on(all, given, p, s - 0.5 / places);
            gap = std::max({gap, foot.distance, back.distance});
            if (gap > enough) return gap;
            before = std::max(before, foot.s);
        }
    }
    return gap;
}

}  // namespace batten::lagrange
