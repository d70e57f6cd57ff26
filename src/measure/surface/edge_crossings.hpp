#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "batten/base/interval.hpp"
#include "num/roots.hpp"

/// Every place where heights along an edge cross a level.
namespace batten::contouring {

/// Bezier ordinates of the cubic through four values at 0, 1/3, 2/3, 1.
inline std::array<double, 4> cubic_ordinates(const std::array<double, 4>& f) {
    return {f[0], (-5 * f[0] + 18 * f[1] - 9 * f[2] + 2 * f[3]) / 6,
            (2 * f[0] - 9 * f[1] + 18 * f[2] - 5 * f[3]) / 6, f[3]};
}

/// Heights less the level along one edge, and the sides on which its ends are taken to be.
template <class Height>
class EdgeCrossings {
public:
    /// `noise`: heights so small have no sign.
    EdgeCrossings(const Height& height, double noise) : height_(height), noise_(noise) {}

    /// The only one between ends of different signs, of those that there are.
    double only(Interval range) const {
        const double lo = height_(range.lo), hi = height_(range.hi);
        if (lo == 0) return range.lo;
        if (hi == 0) return range.hi;
        // Rounding may see one side of a knot line above, the other below the level.
        if ((lo > 0) == (hi > 0)) return std::fabs(lo) < std::fabs(hi) ? range.lo : range.hi;
        return num::find_root(height_, range).at;
    }

    /// All of them, rising: halved until the cubic through four heights has one at most.
    void all(Interval range, bool lo_is_above, bool hi_is_above, std::vector<double>& out,
             int halvings = most_halvings) const {
        if (halvings == 0 || changes(range, lo_is_above, hi_is_above) < 2) {
            if (lo_is_above != hi_is_above) out.push_back(only(range));
            return;
        }
        const double middle = range.middle();
        const bool is_above = height_(middle) >= 0;
        all({range.lo, middle}, lo_is_above, is_above, out, halvings - 1);
        all({middle, range.hi}, is_above, hi_is_above, out, halvings - 1);
    }

private:
    static constexpr int most_halvings = 20;

    int changes(Interval range, bool lo_is_above, bool hi_is_above) const {
        const double third = range.length() / 3;
        const std::array<double, 4> b =
            cubic_ordinates({height_(range.lo), height_(range.lo + third),
                             height_(range.hi - third), height_(range.hi)});
        bool is_above = lo_is_above;
        int count = 0;
        for (const int k : {1, 2}) {
            if (!(std::fabs(b[static_cast<std::size_t>(k)]) > noise_)) continue;
            const bool next = b[static_cast<std::size_t>(k)] >= 0;
            count += next != is_above;
            is_above = next;
        }
        return count + (hi_is_above != is_above);
    }

    const Height& height_;
    double noise_;
};

}  // namespace batten::contouring
