#pragma once

#include <cstddef>
#include <vector>

#include "make/pseudo/local_angles.hpp"

namespace batten::pseudo {

/// Which unknown turns the start and the end of a span; `fixed` if none does.
struct SpanUnknowns {
    static constexpr std::size_t fixed = static_cast<std::size_t>(-1);
    std::size_t start = fixed;
    std::size_t end = fixed;
};

/// The tangent angles that may be turned, numbered along the curve: a span's end comes right after
/// its start, but for the last span of a closed curve, which ends with the first unknown.
struct Unknowns {
    std::vector<SpanUnknowns> of_span;
    std::size_t count = 0;
};

/// One unknown at every smooth point, one on either side of a corner, one at the ends of an open
/// curve, none where the tangent is fixed.
Unknowns number_unknowns(std::size_t points, const AngleRules& rules);

/// The unknowns that turn spans of the window `first`, `first + 1` ... (modulo all spans) only.
Unknowns within_window(const Unknowns& all, std::size_t first, std::size_t spans);

}  // namespace batten::pseudo
