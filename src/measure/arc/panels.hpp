#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>

#include "measure/arc/series.hpp"
#include "num/gauss.hpp"

/// Eight panels of cubic curves at a time: which rules integrate their speeds, and the integrals.
namespace batten::arc {

constexpr std::size_t width = 8;
constexpr int most_dim = 3;

/// Eight numbers that are worked on side by side, whatever vectors the processor has.
typedef double Lane __attribute__((vector_size(64)));

BATTEN_INLINE void root(const Lane& x, Lane& out) {
    alignas(64) double numbers[width];
    std::memcpy(numbers, &x, sizeof x);
#pragma GCC unroll 1
    for (std::size_t l = 0; l < width; ++l) numbers[l] = std::sqrt(numbers[l]);
    std::memcpy(&out, numbers, sizeof out);
}

/// dr/dw of eight panels over w in [0, 1], in the Chebyshev basis of x = 2 w - 1.
struct Panels {
    std::array<std::array<Lane, 3>, most_dim> p{};
};

/// A rule, and the ellipse in which the speed must be analytic for its error to be small.
struct Rule {
    int nodes = 0;
    double linear = 0, square = 0;  ///< (rho + 1 / rho) / 2, (rho^2 + rho^-2) / 2
};

constexpr std::array<int, 9> rule_nodes{2, 6, 8, 10, 12, 14, 16, 20, 24};
/// In the ellipse the speed may be so many times its mean over the panel.
constexpr double most_growth = 2;

/// How many of the rules suit: in their ellipses p.p has no zero and the speed is at most twice its
/// mean.
///
/// In the plane p.p = z conj(z) for z = px + i py, and |T_k| <= (rho^k + rho^-k) / 2: z has no zero
/// where the terms behind the mean add up to less than it.
BATTEN_INLINE void judge_plane(const Panels& panels, std::span<const Rule> rules, Lane& safe) {
    const Lane zero{};
    std::array<Lane, 3> size;
    for (std::size_t j = 0; j < 3; ++j) {
        const Lane x = panels.p[0][j], y = panels.p[1][j];
        root(x * x + y * y, size[j]);
    }
    safe = zero;
    for (const Rule& rule : rules) {
        const Lane off = size[1] * rule.linear + size[2] * rule.square;
        safe += off < size[0] ? zero + 1 : zero;
    }
}

/// In space: | p.p - mean^2 | <= mean^2 in the ellipse; so p.p has no zero there and is at most
/// twice its mean.
BATTEN_INLINE void judge_space(const Panels& panels, std::span<const Rule> rules, Lane& safe) {
    const Lane zero{};
    Lane mean_sq{}, d1{}, d2{}, s1{}, s2{};
    for (const auto& [p0, p1, p2] : panels.p) {
        mean_sq += p0 * p0;
        d1 += p0 * p1;
        d2 += p0 * p2;
        s1 += p1 * p1;
        s2 += p2 * p2;
    }
    d1 = 2 * (d1 < zero ? -d1 : d1);
    d2 = 2 * (d2 < zero ? -d2 : d2);
    root(s1, s1);
    root(s2, s2);
    safe = zero;
    for (const Rule& rule : rules) {
        const Lane size = s1 * rule.linear + s2 * rule.square;
        const Lane off = d1 * rule.linear + d2 * rule.square + size * size;
        safe += ((off <= mean_sq) & (mean_sq > zero)) ? zero + 1 : zero;
    }
}

/// The integrals of the speed by one rule of an even number of nodes.
template <int dim>
BATTEN_INLINE void integrate(const Panels& panels, const num::GaussRule& rule, Lane& out) {
    const Lane zero{};
    Lane sum{};
    for (std::size_t i = rule.nodes.size(); i-- > rule.nodes.size() / 2;) {
        const double x = rule.nodes[i], t2 = 2 * x * x - 1;
        Lane same{}, across{};
        for (int k = 0; k < dim; ++k) {
            const auto& [p0, p1, p2] = panels.p[static_cast<std::size_t>(k)];
            const Lane even = p0 + t2 * p2, odd = x * p1;
            same += even * even + odd * odd;
            across += even * odd;
        }
        across *= 2;
        // Negative by rounding only in lanes that the rule does not suit.
        Lane ahead = same + across, behind = same - across;
        ahead = ahead > zero ? ahead : zero;
        behind = behind > zero ? behind : zero;
        root(ahead, ahead);
        root(behind, behind);
        sum += rule.weights[i] * (ahead + behind);
    }
    out = 0.5 * sum;
}

}  // namespace batten::arc
