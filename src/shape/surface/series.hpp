#pragma once

#include <array>
#include <cstddef>

/// Taylor series of functions of x and y, for derivatives by exact rules.
namespace batten::surfaces {

/// A polynomial in (dx, dy) of total degree N or less; what goes beyond is cut off.
///
/// The terms of one total degree stand together: dx^(n - m) dy^m at n (n + 1) / 2 + m.
template <std::size_t N>
struct Series {
    static constexpr std::size_t size = (N + 1) * (N + 2) / 2;
    static constexpr std::size_t place(std::size_t n, std::size_t m) { return n * (n + 1) / 2 + m; }

    std::array<double, size> c{};

    double& term(std::size_t n, std::size_t m) { return c[place(n, m)]; }
    double term(std::size_t n, std::size_t m) const { return c[place(n, m)]; }

    Series& operator+=(const Series& other) {
        for (std::size_t i = 0; i < size; ++i) c[i] += other.c[i];
        return *this;
    }
    Series& operator-=(const Series& other) {
        for (std::size_t i = 0; i < size; ++i) c[i] -= other.c[i];
        return *this;
    }
    Series& add(double factor, const Series& other) {
        for (std::size_t i = 0; i < size; ++i) c[i] += factor * other.c[i];
        return *this;
    }
};

template <std::size_t N>
Series<N> operator-(Series<N> a, const Series<N>& b) {
    return a -= b;
}

template <std::size_t N>
Series<N> operator*(const Series<N>& a, const Series<N>& b) {
    Series<N> product;
    for (std::size_t n = 0; n <= N; ++n) {
        for (std::size_t m = 0; m <= n; ++m) {
            for (std::size_t t = 0; n + t <= N; ++t) {
                for (std::size_t q = 0; q <= t; ++q) {
                    product.term(n + t, m + q) += a.term(n, m) * b.term(t, q);
                }
            }
        }
    }
    return product;
}

/// `a` / `b`, the value of b not 0.
template <std::size_t N>
Series<N> operator/(const Series<N>& a, const Series<N>& b) {
    Series<N> quotient;
    for (std::size_t n = 0; n <= N; ++n) {
        for (std::size_t m = 0; m <= n; ++m) {
            double rest = a.term(n, m);
            for (std::size_t t = 1; t <= n; ++t) {
                for (std::size_t q = t + m > n ? t + m - n : 0; q <= t && q <= m; ++q) {
                    rest -= b.term(t, q) * quotient.term(n - t, m - q);
                }
            }
            quotient.term(n, m) = rest / b.c[0];
        }
    }
    return quotient;
}

}  // namespace batten::surfaces
