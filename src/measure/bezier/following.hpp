#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "batten/shape/curve.hpp"

namespace batten::bezier {

/// The degree by which the pieces of other than polynomial curves are followed.
inline constexpr int followed_degree = 7;

/// A part of a piece of a curve, and how far a polynomial may be from it.
struct Part {
    std::size_t source = 0;
    Interval t;
    double defect = 0;
};

/// Halves a piece of the curve until on each part the polynomial of degree 7 that shares value and
/// three derivatives with the curve at both ends is within 2^-46 of the piece's extent, or as near
/// as the curve is computed, at three places between. 4 to 2^14 parts.
///
/// defect is twice the largest distance seen, in data units.
std::vector<Part> followed(const Curve& curve, std::size_t source);

/// Throws `curve.not-finite` with the piece and the parameter.
void require_finite_jet(std::span<const double> jet, std::size_t piece, double t);

}  // namespace batten::bezier
