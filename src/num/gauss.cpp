#include "num/gauss.hpp"

#include <array>
#include <cassert>
#include <numbers>
#include <utility>

namespace batten::num {
namespace {

template <int N>
struct Rule {
    std::array<double, N> nodes{};
    std::array<double, N> weights{};
};

/// Taylor series, good to a few ulps for |x| <= pi: only a start for Newton's method.
constexpr long double cosine(long double x) {
    long double term = 1;
    long double sum = 1;
    for (int k = 1; k <= 16; ++k) {
        term *= -x * x / ((2 * k - 1) * (2 * k));
        sum += term;
    }
    return sum;
}

struct Legendre {
    long double value;
    long double slope;
};

/// P_n and its derivative at x, |x| < 1, by the three-term recurrence [DLMF, 18.9.1].
constexpr Legendre legendre(int n, long double x) {
    long double before = 1;
    long double value = x;
    for (int k = 2; k <= n; ++k) {
        const long double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return {value, n * (before - x * value) / (1 - x * x)};
}

/// The i-th root of P_n from the right. Newton from Tricomi's estimate converges quadratically
/// from an error below 0.01 / n^2 to 1e-19 in four steps; six are made.
constexpr long double root(int n, int i) {
    if (2 * i + 1 == n) return 0;
    long double x = cosine(std::numbers::pi_v<long double> * (i + 0.75L) / (n + 0.5L));
    for (int step = 0; step < 6; ++step) {
        const Legendre p = legendre(n, x);
        x -= p.value / p.slope;
    }
    return x;
}

template <int N>
constexpr Rule<N> make_rule() {
    Rule<N> rule;
    for (int i = 0; i < (N + 1) / 2; ++i) {
        const long double x = root(N, i);
        const long double slope = legendre(N, x).slope;
        const double weight = static_cast<double>(2 / ((1 - x * x) * slope * slope));
        rule.nodes[i] = static_cast<double>(-x);
        rule.nodes[N - 1 - i] = static_cast<double>(x);
        rule.weights[i] = rule.weights[N - 1 - i] = weight;
    }
    return rule;
}

// One constant per rule keeps each evaluation below the compilers' constexpr limits.
template <int N>
constexpr Rule<N> rule_of = make_rule<N>();

template <int... N>
constexpr std::array<GaussRule, sizeof...(N)> all_rules(std::integer_sequence<int, N...>) {
    return {GaussRule{rule_of<N + 1>.nodes, rule_of<N + 1>.weights}...};
}

constexpr auto rules = all_rules(std::make_integer_sequence<int, most_gauss_nodes>{});

}  // namespace

GaussRule gauss_legendre(int n) {
    assert(1 <= n && n <= most_gauss_nodes);
    return rules[static_cast<std::size_t>(n - 1)];
}

}  // namespace batten::num
