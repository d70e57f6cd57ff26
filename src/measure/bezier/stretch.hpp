#pragma once

#include <cstddef>
#include <vector>

#include "measure/bezier/pieces.hpp"
#include "num/bernstein.hpp"

namespace batten::bezier {

/// A part of a piece on which the curve moves: with w running from 0 to 1,
///     dr/dw = w^zeros_lo (1 - w)^zeros_hi p(w),   p != 0.
///
/// A piece at rest in its inside (at a cusp, where it turns back) is cut there; a piece that is a
/// single point has no stretch.
struct Stretch {
    std::size_t piece = 0;
    Interval u{0, 1};            ///< of the piece
    int zeros_lo = 0, zeros_hi = 0;
    int dim = 0;
    bernstein::Coefficients p;  ///< Bernstein, coordinate after coordinate

    std::size_t count() const { return p.size() / static_cast<std::size_t>(dim); }
    std::size_t degree() const { return count() - 1; }
    bernstein::View coordinate(int k) const {
        return {p.data() + static_cast<std::size_t>(k) * count(), count()};
    }
    /// The length of the longest coefficient of p.
    double largest() const;
    bool is_whole_motion() const { return zeros_lo == 0 && zeros_hi == 0; }
    double u_of(double w) const { return w == 1 ? u.hi : u.lo + w * u.length(); }
};

/// All stretches of a curve, in order.
///
/// At rest means: at an end a speed within 2^-50 of the piece's largest hodograph coefficient;
/// inside a minimum of the speed below 2^-40 of it (setting that to zero changes the length by
/// less than 2^-79 of it, as the change is of second order there).
std::vector<Stretch> stretches(const Pieces& pieces);

/// The length of coefficient j, all coordinates together.
double coefficient_norm(const bernstein::Coefficients& c, int dim, std::size_t j);

/// The length of the control polygon, which that of the piece does not exceed, in normal units.
double polygon_length(const Pieces& pieces, std::size_t piece);

}  // namespace batten::bezier
