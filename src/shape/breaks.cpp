#include "shape/breaks.hpp"

#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::knots {

void require_breaks(std::span<const double> breaks) {
    if (breaks.size() < 2) {
        throw Error("curve.breaks", "breaks", std::to_string(breaks.size()),
                    "a curve needs at least two breaks");
    }
    for (std::size_t i = 0; i < breaks.size(); ++i) {
        if (!std::isfinite(breaks[i]) || (i > 0 && !(breaks[i - 1] < breaks[i]))) {
            throw Error("curve.breaks", "break " + std::to_string(i), format_number(breaks[i]),
                        "breaks must be finite and strictly increasing");
        }
    }
}

}  // namespace batten::knots
