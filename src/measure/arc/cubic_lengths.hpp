#pragma once

#include <cstddef>
#include <vector>

#include "batten/base/tolerance.hpp"
#include "batten/measure/measured.hpp"
#include "batten/shape/piecewise_cubic.hpp"

namespace batten::arc {

/// The lengths of cubic pieces, eight at a time, in data units.
struct CubicLengths {
    std::vector<Measured> pieces;
    /// Those that were left out, rising: with cusps, at rest at an end, a single point; or all,
    /// where the curve is beyond 2^+-400 in size, or not in the plane or in space.
    std::vector<std::size_t> left_out;
};

/// |value - length| <= error for each piece, and all errors together are within the tolerance or
/// within 2^-50 of the length.
///
/// As `bezier::lengths`: Gauss-Legendre with as many nodes as a bound in the complex plane asks
/// for, 24 at most; where that is too few the piece is halved, up to 40 times. Relative tolerances
/// refer to the box around the joints.
/// Cost: about 20 ns a gentle plane cubic, 260 ns one of four random control points.
/// Source: [Trefethen2013, theorem 19.3].
CubicLengths cubic_lengths(const PiecewiseCubic& curve, Tolerance tolerance);

}  // namespace batten::arc
