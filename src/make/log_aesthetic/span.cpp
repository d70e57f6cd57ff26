#include "make/log_aesthetic/span.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "num/gauss.hpp"
#include "shape/log_aesthetic/profile.hpp"

namespace batten::spiral {
namespace {

using Complex = std::complex<double>;

/// int y^k e^(i d(y)) dy over [-1/2, 1/2] for k = 0, 1, 2.
struct Moments {
    Complex m0, m1, m2;
};

constexpr double short_bend = 1;  ///< largest |d| for which few nodes and the series do

constexpr std::size_t few = 10;

/// Nodes and weights on [-1/2, 1/2].
struct Nodes {
    std::array<double, few> y, weight;
};

const Nodes& few_nodes() {
    static const Nodes nodes = [] {
        Nodes result{};
        const num::GaussRule rule = num::gauss_legendre(few);
        for (std::size_t i = 0; i < few; ++i) {
            result.y[i] = 0.5 * rule.nodes[i];
            result.weight[i] = 0.5 * rule.weights[i];
        }
        return result;
    }();
    return nodes;
}

/// d = slope y + half y^2, |d| <= short_bend: sine and cosine by their series, all nodes alike.
Moments short_moments(double slope, double half) {
    const Nodes& nodes = few_nodes();
    std::array<double, few> sine, cosine;
    for (std::size_t i = 0; i < few; ++i) {
        const double d = nodes.y[i] * (slope + half * nodes.y[i]), z = d * d;
        double s = -1.0 / 1307674368000 * z + 1.0 / 6227020800;
        s = s * z - 1.0 / 39916800, s = s * z + 1.0 / 362880, s = s * z - 1.0 / 5040;
        s = s * z + 1.0 / 120, s = s * z - 1.0 / 6, s = s * z + 1;
        double c = 1.0 / 20922789888000 * z - 1.0 / 87178291200;
        c = c * z + 1.0 / 479001600, c = c * z - 1.0 / 3628800, c = c * z + 1.0 / 40320;
        c = c * z - 1.0 / 720, c = c * z + 1.0 / 24, c = c * z - 0.5, c = c * z + 1;
        sine[i] = nodes.weight[i] * s * d;
        cosine[i] = nodes.weight[i] * c;
    }
    double c0 = 0, c1 = 0, c2 = 0, s0 = 0, s1 = 0, s2 = 0;
    for (std::size_t i = 0; i < few; ++i) {
        const double y = nodes.y[i];
        c0 += cosine[i], c1 += cosine[i] * y, c2 += cosine[i] * y * y;
        s0 += sine[i], s1 += sine[i] * y, s2 += sine[i] * y * y;
    }
    return {{c0, s0}, {c1, s1}, {c2, s2}};
}

Moments long_moments(double slope, double half) {
    const double change = std::fabs(slope) + std::fabs(half);
    const int panels = 1 + static_cast<int>(std::fmin(change / 6, 1e5));
    const num::GaussRule rule = num::gauss_legendre(16);
    Moments sum{};
    for (int k = 0; k < panels; ++k) {
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double y = (k + 0.5 * (1 + rule.nodes[i])) / panels - 0.5;
            const Complex term =
                std::polar(0.5 * rule.weights[i] / panels, y * (slope + half * y));
            sum.m0 += term, sum.m1 += y * term, sum.m2 += y * y * term;
        }
    }
    return sum;
}

SpanJet clothoid_jet(double angle, Bends b) {
    const double slope = 0.5 * (b.start + b.end), half = 0.5 * (b.end - b.start);
    const bool is_short = 0.5 * std::fabs(slope) + 0.25 * std::fabs(half) <= short_bend &&
                          std::fabs(half) <= 2 * short_bend;
    const Moments m = is_short ? short_moments(slope, half) : long_moments(slope, half);
    const double middle = angle + 0.5 * b.start + 0.25 * half;
    const Complex turned(std::cos(middle), std::sin(middle));
    const Complex x1 = m.m1 + 0.5 * m.m0, x2 = m.m2 + m.m1 + 0.25 * m.m0;
    const Complex ahead(-turned.imag(), turned.real());  // i turned
    const Complex by_start = x1 - 0.5 * x2, by_end = 0.5 * x2;
    const auto times = [](Complex a, Complex b) {
        return Complex(a.real() * b.real() - a.imag() * b.imag(),
                       a.real() * b.imag() + a.imag() * b.real());
    };
    return {slope, 0.5, 0.5, times(turned, m.m0), times(ahead, by_start), times(ahead, by_end)};
}

/// Turn and end point of length 1 from the x axis.
struct Reach {
    double turn;
    Complex end;
};

Reach reach_of(double alpha, Bends b) {
    const Profile profile({span_alpha(alpha, b), 1, b.start, b.end});
    return {profile.turn(), profile.end()};
}

SpanJet general_jet(double alpha, double angle, Bends b) {
    const double step = 1e-7 * (std::fabs(b.start) + std::fabs(b.end) + 1e-3);
    const Reach at = reach_of(alpha, b), start = reach_of(alpha, {b.start + step, b.end}),
                end = reach_of(alpha, {b.start, b.end + step});
    const Complex turned = std::polar(1.0, angle);
    return {at.turn,
            (start.turn - at.turn) / step,
            (end.turn - at.turn) / step,
            turned * at.end,
            turned * (start.end - at.end) / step,
            turned * (end.end - at.end) / step};
}

}  // namespace

double span_alpha(double alpha, Bends b) {
    if (alpha == -1 || !(b.start * b.end > 0)) return -1;
    // A narrower blend would let the chord's angle fall and rise again with the curvatures' ratio.
    const double pure = std::fmin(1, 0.1 + 0.2 * std::fabs(alpha + 1));
    const double small = std::fmin(std::fabs(b.start), std::fabs(b.end));
    const double large = std::fmax(std::fabs(b.start), std::fabs(b.end));
    const double x = std::fmin(1, small / large / pure);
    if (x < 1e-4) return -1;  // what is left of alpha + 1 is below 3e-8
    return -1 + (alpha + 1) * x * x * (3 - 2 * x);
}

SpanJet span_jet(double alpha, double angle, Bends b) {
    return alpha == -1 ? clothoid_jet(angle, b) : general_jet(alpha, angle, b);
}

bool settle(double alpha, double angle0, double angle1, Bends& bends) {
    constexpr int most_steps = 40;
    const double wanted = angle1 - angle0;
    double last = 1e300;
    Bends step{};
    for (int i = 0; i < most_steps; ++i) {
        const SpanJet jet = span_jet(alpha, angle0, bends);
        const double turn_miss = wanted - jet.turn, side_miss = -jet.reach.imag();
        const double miss = std::fabs(turn_miss) + std::fabs(side_miss);
        if (!(miss < 2 * last)) {  // half a step back
            step = {0.5 * step.start, 0.5 * step.end};
            bends = {bends.start - step.start, bends.end - step.end};
            continue;
        }
        last = miss;
        if (miss < 1e-13) return jet.reach.real() > 0;
        const double det = jet.turn_start * jet.reach_end.imag() -
                           jet.turn_end * jet.reach_start.imag();
        if (det == 0) return false;
        step = {(turn_miss * jet.reach_end.imag() - jet.turn_end * side_miss) / det,
                (jet.turn_start * side_miss - turn_miss * jet.reach_start.imag()) / det};
        const double size = std::fabs(step.start) + std::fabs(step.end);
        const double share = std::fmin(1, (4 + std::fabs(wanted)) / size);
        step = {share * step.start, share * step.end};
        bends = {bends.start + step.start, bends.end + step.end};
    }
    return false;
}

}  // namespace batten::spiral
