#pragma once

#include "make/pseudo/tables/tabulated.hpp"

namespace batten::pseudo {

/// J, J' and J'' of a free end.
struct Slopes {
    double value, first, second;
};

/// Those of a piece of the table at theta >= 0. J'' is positive on every piece.
inline Slopes slopes_on(const EndPiece& piece, double theta) {
    const double scale = 2 / (piece.hi - piece.lo);
    const double x = (theta - 0.5 * (piece.lo + piece.hi)) * scale;
    double e = piece.energy[end_size - 1], slope = 0, half_second = 0;
    for (std::size_t k = end_size - 1; k-- > 0;) {
        half_second = half_second * x + slope;
        slope = slope * x + e;
        e = e * x + piece.energy[k];
    }
    slope *= scale;
    const double second = 2 * half_second * scale * scale;
    return {theta * theta * e, theta * (2 * e + theta * slope),
            2 * e + theta * (4 * slope + theta * second)};
}

/// The piece that 0 <= theta <= pi lies in, the right one at a kink.
const EndPiece& piece_at(double theta);

}  // namespace batten::pseudo
