#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"

/// Polynomials c[0] B_0^n(u) + ... + c[n] B_n^n(u) on 0 <= u <= 1.
///
/// A polynomial lies between its smallest and largest coefficient, and has no more zeros than its
/// coefficients change sign: searches that rest on this miss nothing [Farouki2012].
namespace batten::bernstein {

/// The n + 1 coefficients, or those of several coordinates one after the other. Up to 16 numbers
/// are held without allocation.
class Coefficients {
public:
    Coefficients() = default;
    explicit Coefficients(std::size_t count) : count_(count) {
        if (count > few_.size()) many_.resize(count);
    }
    explicit Coefficients(std::span<const double> values) : Coefficients(values.size()) {
        std::copy(values.begin(), values.end(), data());
    }

    std::size_t size() const { return count_; }
    double* data() { return many_.empty() ? few_.data() : many_.data(); }
    const double* data() const { return many_.empty() ? few_.data() : many_.data(); }
    double& operator[](std::size_t i) { return data()[i]; }
    double operator[](std::size_t i) const { return data()[i]; }
    double* begin() { return data(); }
    double* end() { return data() + count_; }
    const double* begin() const { return data(); }
    const double* end() const { return data() + count_; }

private:
    std::size_t count_ = 0;
    std::array<double, 16> few_{};
    std::vector<double> many_;
};

using View = std::span<const double>;

/// n over k.
double binomial(std::size_t n, std::size_t k);

/// The polynomial at u. Exact at both ends; elsewhere backward stable. Cost: n (n + 1) / 2 steps.
/// Source: de Casteljau [Farouki2012].
double value(View c, double u);

/// The largest coefficient in magnitude: no value on [0, 1] is larger.
double bound(View c);

/// d/du. Of a constant: the constant 0.
Coefficients derivative(View c);

/// a b, of degree deg a + deg b [Farouki2012].
Coefficients product(View a, View b);

/// a + factor b for equal degrees.
Coefficients combination(View a, double factor, View b);

/// The same polynomial written with a higher degree.
Coefficients raised(View c, std::size_t degree);

/// The same polynomial over [0, u] and over [u, 1], each again on [0, 1].
struct Halves {
    Coefficients left, right;
};
Halves split(View c, double u);

/// The same polynomial over `part` of [0, 1], again on [0, 1].
Coefficients restricted(View c, Interval part);

/// The polynomial divided by u; c[0] is taken to be 0. Likewise by (1 - u); c[n] is taken to be 0.
Coefficients without_zero_at_start(View c);
Coefficients without_zero_at_end(View c);

/// All u in [0, 1], rising, where the polynomial is 0 within `noise`, the error of its
/// coefficients: crossings, and touches from one side. Zeros that the noise does not tell apart
/// are listed once. Empty if no coefficient exceeds the noise: then every u is a zero.
///
/// Accuracy: a simple zero is placed within noise / |slope| + 4 ulp.
/// Cost: about 40 steps of degree n^2 for a simple zero, a few thousand for a touch.
/// Source: subdivision until the coefficients change sign once [Farouki2012].
std::vector<double> roots(View c, double noise);

/// A stretch where the polynomial has one sign, beyond noise.
struct SignRun {
    Interval where;
    int sign = 0;
};

/// The stretches of constant sign in order; neighbours differ in sign, and a touch does not end a
/// run. Empty if no coefficient exceeds the noise.
std::vector<SignRun> sign_runs(View c, double noise);

}  // namespace batten::bernstein
