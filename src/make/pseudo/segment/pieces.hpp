#pragma once

#include <array>
#include <complex>

#include "batten/base/interval.hpp"
#include "num/gauss.hpp"

namespace batten::pseudo {

/// A part of [0, 1] and the Gauss rule that is safe on it.
struct Piece {
    Interval part;
    num::GaussRule rule;
};

/// Cuts [0, 1] into pieces on which Gauss rules integrate |w|, N^2 |w|^-5 and their derivatives to
/// the rounding error, for a complex quadratic w with the given roots (which are the only
/// singularities of these functions, with their mirror images in the real axis).
///
/// A piece is safe if every root lies outside an ellipse with the piece's ends as foci whose
/// Bernstein radius suits the number of nodes; else it is bisected. On 1500 random, clustered,
/// conjugate and double roots per radius, the rules below left errors under 2e-16 of the integral
/// of the absolute value, for integrands up to |w|^-7. Widths shrink geometrically to a root at a
/// distance d: about log2(1/d) pieces.
class Pieces {
public:
    Pieces(const std::complex<double>* roots, int count);

    /// False after the last piece, and where a root comes so near to [0, 1] that 40 halvings do
    /// not suffice: a cusp, `is_singular()`.
    bool next(Piece& piece);
    bool is_singular() const { return is_singular_; }

private:
    int nodes_for(Interval part) const;

    std::array<std::complex<double>, 2> roots_{};
    int count_ = 0;
    int level_ = 0;
    unsigned long long index_ = 0;
    bool is_done_ = false;
    bool is_singular_ = false;
};

}  // namespace batten::pseudo
