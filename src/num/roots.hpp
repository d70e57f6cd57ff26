#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include "batten/base/interval.hpp"

namespace batten::num {

/// The real roots of a polynomial of degree 3 or less, rising. A double root is listed twice.
struct RealRoots {
    std::array<double, 3> values{};
    int count = 0;

    const double* begin() const { return values.data(); }
    const double* end() const { return values.data() + count; }
    double operator[](int i) const { return values[static_cast<std::size_t>(i)]; }
};

/// Real roots of c[0] + c[1] t + c[2] t^2. Leading zeros are allowed; the zero polynomial and
/// non-zero constants have no roots, and a root beyond the range of double is left out.
/// Coefficients below 1e-307 of the largest count as zero.
///
/// Accuracy: a few ulps per root, since the discriminant is made with one rounding; whether a
/// double root exists is decided on the coefficients as given.
/// Laws: coefficients x 2^k give the same roots.
/// Source: the discriminant by fused multiply-add [Kahan2004].
RealRoots real_roots(const std::array<double, 3>& c);

/// Real roots of c[0] + c[1] t + c[2] t^2 + c[3] t^3, as above.
///
/// Accuracy: backward stable, each root is exact for coefficients a few ulps away; a double root
/// may therefore come out as two roots, or none, with the error sqrt(ulp).
/// Source: Newton from outside the outermost root, then a stable deflation [Kahan1986].
RealRoots real_roots(const std::array<double, 4>& c);

/// The roots of a complex polynomial of degree 2 or less.
struct ComplexRoots {
    std::array<std::complex<double>, 2> values{};
    int count = 0;

    const std::complex<double>* begin() const { return values.data(); }
    const std::complex<double>* end() const { return values.data() + count; }
};

/// Roots of c[0] + c[1] z + c[2] z^2; as for the real quadratic, but nearly double roots have the
/// error sqrt(ulp). Laws: coefficients x 2^k give the same roots.
ComplexRoots complex_roots(const std::array<std::complex<double>, 3>& c);

/// Where a search ended: the point, the function there and the number of values it took.
struct ScalarPoint {
    double at = 0;
    double value = 0;
    int evaluations = 0;
};

/// A zero of `f` in `bracket`, where f(lo) and f(hi) must differ in sign (or one be zero).
///
/// Aim: |at - zero| <= tolerance + 4 ulp(at); `tolerance` is in units of the argument. A zero at
/// 0 has no ulp to stop at: there 2^-104 of the bracket is small enough.
/// Cost: about 8 evaluations for smooth f; bisection at worst.
/// Source: inverse quadratic interpolation where it is safe, else bisection [Chandrupatla1997].
template <class F>
ScalarPoint find_root(F&& f, Interval bracket, double tolerance = 0) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double floor = std::fmax(tolerance, epsilon * epsilon * bracket.length());
    ScalarPoint a{bracket.lo, f(bracket.lo), 1};
    ScalarPoint b{bracket.hi, f(bracket.hi), 2};
    double share = 0.5;  // the next point is a + share (b - a); a and b enclose the zero
    while (true) {
        const ScalarPoint& best = std::fabs(a.value) < std::fabs(b.value) ? a : b;
        const double close = 2 * epsilon * std::fabs(best.at) + floor;
        const double width = std::fabs(b.at - a.at);
        const int evaluations = std::max(a.evaluations, b.evaluations);
        if (best.value == 0 || width <= close) return {best.at, best.value, evaluations};
        const double least = std::fmin(0.5, 0.5 * close / width);
        share = std::fmin(std::fmax(share, least), 1 - least);
        const double at = a.at + share * (b.at - a.at);
        ScalarPoint c = a;  // the point that leaves the bracket
        const ScalarPoint fresh{at, f(at), evaluations + 1};
        if ((fresh.value > 0) != (a.value > 0)) {
            c = b;
            b = a;
        }
        a = fresh;
        const double xi = (a.at - b.at) / (c.at - b.at);
        const double phi = (a.value - b.value) / (c.value - b.value);
        share = 0.5;
        if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi) {
            share = a.value / (b.value - a.value) * (c.value / (b.value - c.value)) +
                    (c.at - a.at) / (b.at - a.at) * (a.value / (c.value - a.value)) *
                        (b.value / (c.value - b.value));
        }
    }
}

/// The three lowest points seen by `find_minimum`, lowest first, and what encloses the minimum.
struct LowestPoints {
    ScalarPoint best, second, third;
    Interval bracket;

    void add(const ScalarPoint& fresh);
    /// The step from `best` to the vertex of the parabola through the three points; 0 if the
    /// vertex leaves the bracket or the step is not shorter than half of `longest`.
    double parabola_step(double longest) const;
};

/// A local minimum of `f` in `bracket`, searched from `start` inside it.
///
/// Aim: |at - minimum| <= 3 (tolerance + sqrt(epsilon) |at|) for unimodal f: a minimum cannot be
/// placed better than by the square root of the error of f. f(at) <= every value it has seen.
/// Cost: about 15 evaluations for smooth f, 1.44 log2(length / tolerance) at worst.
/// Source: parabolas guarded by golden sections [Brent1973, chapter 5].
template <class F>
ScalarPoint find_minimum(F&& f, Interval bracket, double start, double tolerance = 0) {
    constexpr double golden = 0.3819660112501051;  // (3 - sqrt 5) / 2
    constexpr double root_epsilon = 1.4901161193847656e-8;
    const double floor = std::fmax(tolerance, 1e-3 * root_epsilon * bracket.length());
    const ScalarPoint first{start, f(start), 1};
    LowestPoints seen{first, first, first, bracket};
    double step = 0;
    double step_before = 0;
    for (int evaluations = 1;;) {
        const auto [lo, hi] = seen.bracket;
        const double x = seen.best.at;
        const double close = root_epsilon * std::fabs(x) + floor;
        if (std::fmax(x - lo, hi - x) <= 2 * close) {
            return {x, seen.best.value, evaluations};
        }
        const double middle = seen.bracket.middle();
        const double parabola =
            std::fabs(step_before) > close ? seen.parabola_step(step_before) : 0;
        step_before = step;
        step = parabola;
        if (step == 0) {
            step_before = x < middle ? hi - x : lo - x;
            step = golden * step_before;
        } else if (x + step - lo < 2 * close || hi - x - step < 2 * close) {
            step = std::copysign(close, middle - x);
        }
        const double at = x + (std::fabs(step) >= close ? step : std::copysign(close, step));
        seen.add({at, f(at), ++evaluations});
    }
}

}  // namespace batten::num
