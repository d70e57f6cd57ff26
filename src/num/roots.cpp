#include "num/roots.hpp"

namespace batten::num {
namespace {

/// 2^-e with e the exponent of the largest of the numbers, or 0 if all are zero.
template <std::size_t N>
double unit_scale(const std::array<double, N>& values) {
    double largest = 0;
    for (double value : values) largest = std::fmax(largest, std::fabs(value));
    if (largest == 0) return 0;
    int exponent = 0;
    std::frexp(largest, &exponent);
    return std::ldexp(1.0, std::min(-exponent, 1023));
}

/// b^2 - a c with one rounding's error [Kahan2004].
double discriminant(double a, double b, double c) {
    const double square = b * b;
    const double product = a * c;
    const double square_error = std::fma(b, b, -square);
    const double product_error = std::fma(a, c, -product);
    return (square - product) + (square_error - product_error);
}

/// Keeps the roots rising; -0 becomes 0.
void add_finite(RealRoots& roots, double value) {
    if (!std::isfinite(value)) return;
    int place = roots.count++;
    for (; place > 0 && roots[place - 1] > value; --place) {
        roots.values[static_cast<std::size_t>(place)] = roots[place - 1];
    }
    roots.values[static_cast<std::size_t>(place)] = value + 0.0;
}

/// The cubic at x, its slope, and the coefficients of (cubic - value) / (t - x).
struct Deflated {
    double value, slope;
    double c1, c0;
};

Deflated deflate(const std::array<double, 4>& c, double x) {
    const double lead = c[3] * x;
    const double c1 = lead + c[2];
    const double c0 = c1 * x + c[1];
    return {c0 * x + c[0], (lead + c1) * x + c0, c1, c0};
}

/// One real root of a cubic with c[0] and c[3] not zero. The start lies outside the outermost
/// root on the side the value at the inflection points to, so Newton's method runs monotonically
/// and has ended when it turns back [Kahan1986].
double outer_root(const std::array<double, 4>& c) {
    constexpr double plastic = 1.324718;     // real root of x^3 = x + 1
    constexpr double shorter = 1.000000001;  // keeps rounding from overshooting the root
    double x = -(c[2] / c[3]) / 3;
    Deflated at = deflate(c, x);
    const double ratio = at.value / c[3];
    const double side = std::copysign(1.0, ratio);
    double reach = std::cbrt(std::fabs(ratio));
    const double spread = -at.slope / c[3];
    if (spread > 0) reach = plastic * std::fmax(reach, std::sqrt(spread));
    double next = x - side * reach;
    while (next != x && std::isfinite(next)) {
        x = next;
        at = deflate(c, x);
        if (at.slope == 0) break;
        next = x - at.value / at.slope / shorter;
        if (!(side * next > side * x)) break;
    }
    return x;
}

void add_finite(ComplexRoots& roots, std::complex<double> value) {
    if (!std::isfinite(value.real()) || !std::isfinite(value.imag())) return;
    roots.values[static_cast<std::size_t>(roots.count++)] = value;
}

// Complex arithmetic of numbers that are not far above 1, some five times faster than the
// standard's, which must care for infinities.

std::complex<double> product(std::complex<double> a, std::complex<double> b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

std::complex<double> quotient(std::complex<double> a, std::complex<double> b) {
    const double norm = b.real() * b.real() + b.imag() * b.imag();
    if (norm < 1e-200) return a / b;
    return {(a.real() * b.real() + a.imag() * b.imag()) / norm,
            (a.imag() * b.real() - a.real() * b.imag()) / norm};
}

std::complex<double> square_root(std::complex<double> z) {
    const double norm = z.real() * z.real() + z.imag() * z.imag();
    if (norm < 1e-200) return std::sqrt(z);
    const double larger = std::sqrt(0.5 * (std::sqrt(norm) + std::fabs(z.real())));
    const double smaller = 0.5 * std::fabs(z.imag()) / larger;
    return z.real() >= 0 ? std::complex<double>(larger, std::copysign(smaller, z.imag()))
                         : std::complex<double>(smaller, std::copysign(larger, z.imag()));
}

}  // namespace

RealRoots real_roots(const std::array<double, 3>& given) {
    RealRoots roots;
    const double scale = unit_scale(given);
    const double c = given[0] * scale;
    const double half = -0.5 * given[1] * scale;
    const double a = given[2] * scale;
    if (a == 0) {
        if (half != 0) add_finite(roots, 0.5 * c / half);
        return roots;
    }
    const double d = discriminant(a, half, c);
    if (d < 0) return roots;
    const double q = half + std::copysign(std::sqrt(d), half);
    add_finite(roots, q / a);
    add_finite(roots, q == 0 ? 0.0 : c / q);
    return roots;
}

RealRoots real_roots(const std::array<double, 4>& given) {
    const double scale = unit_scale(given);
    std::array<double, 4> c = given;
    for (double& value : c) value *= scale;
    double x = 0;
    std::array<double, 3> rest{c[1], c[2], c[3]};
    if (c[3] == 0) return real_roots(std::array<double, 3>{c[0], c[1], c[2]});
    if (c[0] != 0) {
        x = outer_root(c);
        if (!std::isfinite(x)) return real_roots(std::array<double, 3>{c[0], c[1], c[2]});
        const Deflated at = deflate(c, x);
        rest = {at.c0, at.c1, c[3]};
        if (std::fabs(c[3]) * x * x > std::fabs(c[0] / x)) {
            rest[0] = -c[0] / x;
            rest[1] = (rest[0] - c[1]) / x;
        }
    }
    RealRoots roots = real_roots(rest);
    add_finite(roots, x);
    return roots;
}

ComplexRoots complex_roots(const std::array<std::complex<double>, 3>& given) {
    ComplexRoots roots;
    const double scale =
        unit_scale(std::array<double, 6>{given[0].real(), given[0].imag(), given[1].real(),
                                         given[1].imag(), given[2].real(), given[2].imag()});
    const std::complex<double> c = given[0] * scale;
    const std::complex<double> half = -0.5 * scale * given[1];
    const std::complex<double> a = given[2] * scale;
    if (a == 0.0) {
        if (half != 0.0) add_finite(roots, quotient(0.5 * c, half));
        return roots;
    }
    std::complex<double> d = square_root(product(half, half) - product(a, c));
    if (half.real() * d.real() + half.imag() * d.imag() < 0) d = -d;
    const std::complex<double> q = half + d;
    add_finite(roots, quotient(q, a));
    add_finite(roots, q == 0.0 ? 0.0 : quotient(c, q));
    return roots;
}

void LowestPoints::add(const ScalarPoint& fresh) {
    if (fresh.value <= best.value) {
        (fresh.at >= best.at ? bracket.lo : bracket.hi) = best.at;
        third = second;
        second = best;
        best = fresh;
        return;
    }
    (fresh.at < best.at ? bracket.lo : bracket.hi) = fresh.at;
    if (fresh.value <= second.value || second.at == best.at) {
        third = second;
        second = fresh;
    } else if (fresh.value <= third.value || third.at == best.at || third.at == second.at) {
        third = fresh;
    }
}

double LowestPoints::parabola_step(double longest) const {
    const double r = (best.at - second.at) * (best.value - third.value);
    const double s = (best.at - third.at) * (best.value - second.value);
    double p = (best.at - third.at) * s - (best.at - second.at) * r;
    double q = 2 * (s - r);
    if (q > 0) p = -p;
    q = std::fabs(q);
    const bool is_inside = std::fabs(p) < std::fabs(0.5 * q * longest) &&
                           p > q * (bracket.lo - best.at) && p < q * (bracket.hi - best.at);
    return is_inside ? p / q : 0;
}

}  // namespace batten::num
