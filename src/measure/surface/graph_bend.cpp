#include "batten/measure/graph_bend.hpp"

#include <cmath>

namespace batten {

GraphBend graph_bend(const HeightJet& jet) {
    const double length = std::hypot(1.0, jet.x, jet.y);
    const double nx = jet.x / length, ny = jet.y / length, nz = 1 / length;
    // Second derivatives against the unit normal; the metric's inverse is
    // [1 - nx^2, -nx ny; -nx ny, 1 - ny^2], free of overflow for any slope.
    const double l = jet.xx * nz, m = jet.xy * nz, n = jet.yy * nz;
    const double mean = 0.5 * (l * (1 - nx * nx) - 2 * m * nx * ny + n * (1 - ny * ny));
    const double gaussian = (l * n - m * m) * nz * nz;
    const double half_gap = std::sqrt(std::fmax(0.0, mean * mean - gaussian));
    return {{-nx, -ny, nz}, gaussian, mean, mean + half_gap, mean - half_gap};
}

}  // namespace batten
