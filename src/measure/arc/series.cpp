#include "measure/arc/series.hpp"

#include <cmath>
#include <numbers>

namespace batten::arc {

template <std::size_t N>
Nodes<N>::Nodes() {
    constexpr double step = std::numbers::pi / static_cast<double>(N);
    for (std::size_t i = 0; i < N; ++i) {
        const double angle = step * (static_cast<double>(i) + 0.5);
        at[i] = std::cos(angle);
        between[i] = std::cos(step * static_cast<double>(i));
        for (std::size_t k = 0; k < N; ++k) {
            const double share = (k == 0 ? 1.0 : 2.0) / static_cast<double>(N);
            to_coefficients[i][k] = share * std::cos(static_cast<double>(k) * angle);
        }
    }
}

template <std::size_t N>
const Nodes<N>& nodes() {
    static const Nodes<N> made;
    return made;
}

template const Nodes<16>& nodes<16>();
template const Nodes<24>& nodes<24>();

}  // namespace batten::arc
