#pragma once

#include <cstddef>
#include <span>

#include "batten/base/interval.hpp"

namespace batten::num {

/// Nodes (rising) and weights of one Gauss-Legendre rule on [-1, 1].
///
/// The rule is symmetric to the last bit: node(i) = -node(n-1-i), weight(i) = weight(n-1-i).
struct GaussRule {
    std::span<const double> nodes;
    std::span<const double> weights;
};

constexpr int most_gauss_nodes = 64;

/// The rule with `n` nodes, 1 <= n <= most_gauss_nodes: exact for polynomials of degree 2n - 1.
///
/// Accuracy: every node and weight is the extended-precision value rounded once to double.
/// Cost: none, the rules are constants made by the compiler.
/// Source: [DLMF, 3.5(v)].
GaussRule gauss_legendre(int n);

/// Integral of `f` over `part` by one rule: no error estimate, sums in the order of the nodes.
template <class F>
double integrate(F&& f, Interval part, GaussRule rule) {
    const double half = 0.5 * part.length();
    const double middle = part.middle();
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        sum += rule.weights[i] * f(middle + half * rule.nodes[i]);
    }
    return half * sum;
}

}  // namespace batten::num
