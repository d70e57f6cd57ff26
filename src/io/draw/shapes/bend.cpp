#include "io/draw/shapes/bend.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "num/roots.hpp"

namespace batten::drawing {
namespace {

constexpr double sharpest = 1e4;  ///< radius 1e-4 of the picture: a corner to the eye

}  // namespace

Bend bend_of(const Curve& curve, std::size_t piece, double t, double size) {
    const std::size_t dim = static_cast<std::size_t>(curve.dim());
    std::array<double, 9> jet{};
    curve.jets_on(piece, {&t, 1}, 2, {jet.data(), 3 * dim});
    Bend bend;
    std::copy_n(jet.begin(), dim, bend.at.begin());
    const Spot first{jet[dim], jet[dim + 1], dim == 3 ? jet[5] : 0};
    const double speed = distance(first, {});
    if (!(speed > 0) || !std::isfinite(speed)) return bend;
    // kappa size = |second - (second . T) T| / speed * (size / speed): no square of a length, so
    // nothing overflows or vanishes that need not.
    Spot second{};
    double along = 0;
    for (std::size_t k = 0; k < dim; ++k) {
        bend.tangent[k] = first[k] / speed;
        second[k] = jet[2 * dim + k] / speed;
        along += second[k] * bend.tangent[k];
    }
    Spot across{};
    for (std::size_t k = 0; k < dim; ++k) across[k] = second[k] - along * bend.tangent[k];
    const double turn = distance(across, {});
    const double left = bend.tangent[0] * second[1] - bend.tangent[1] * second[0];
    bend.curvature = (dim == 2 ? left : turn) * (size / speed);
    bend.exists = std::fabs(bend.curvature) <= sharpest;
    if (turn > 0 && bend.exists) {
        for (std::size_t k = 0; k < dim; ++k) bend.outward[k] = -across[k] / turn;
    }
    return bend;
}

double peak_curvature(const Curve& curve, double size) {
    const int chords = least_chords(curve);
    double peak = 0;
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const Interval piece = curve.piece(i);
        const auto bending = [&](double t) {
            const Bend bend = bend_of(curve, i, t, size);
            return bend.exists ? std::fabs(bend.curvature) : 0.0;
        };
        const double step = piece.length() / chords;
        double highest = 0, at = piece.lo;
        for (int j = 0; j <= chords; ++j) {
            const double t = j == chords ? piece.hi : piece.lo + j * step;
            const double here = bending(t);
            if (here > highest) {
                highest = here;
                at = t;
            }
        }
        peak = std::max(peak, highest);
        if (4 * highest < peak || highest == 0) continue;
        const Interval around{piece.clamp(at - step), piece.clamp(at + step)};
        const auto lowest = num::find_minimum([&](double t) { return -bending(t); }, around, at,
                                              1e-4 * step);
        peak = std::max(peak, -lowest.value);
    }
    return peak;
}

}  // namespace batten::drawing
