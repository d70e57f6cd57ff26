#pragma once

#include <optional>

#include "batten/measure/measured.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// Signed area enclosed by a plane curve, counter-clockwise positive; an open curve is closed by
/// its chord. Where the curve winds around a place several times, that place counts as often.
///
/// Aim:    exact but for rounding where the pieces are polynomials; elsewhere within the distance
///         at which the curve is followed (2^-45 of the extent) times the length.
/// Laws:   the area does not depend on where the origin is; points times 2^k give exactly 4^k
///         times the area; reversal changes the sign.
/// Cost:   about 1 us a cubic.
/// Throws: `curve.dimension` unless the curve is plane; `curve.not-finite`; `number.overflow`.
/// Source: [InoueShibata, eq. 18] without the modulus.
Measured area(const Curve& curve);

/// The signed area's two parts: both are at least 0, and area = positive - negative.
struct AreasByWinding {
    double positive = 0;  ///< int max(w, 0) over the plane, w being the winding number
    double negative = 0;  ///< int max(-w, 0)
};

/// The parts of the area that the curve winds around to the left and to the right. Nothing if the
/// curve crosses itself so often that this would take more than about a second.
///
/// Aim:    error <= 1e-11 of the extent squared for each place where the curve crosses itself.
/// Cost:   grows like (crossings + turning points in y) x (branches at one y).
/// Throws: as `area`.
std::optional<AreasByWinding> areas_by_winding(const Curve& curve);

}  // namespace batten
