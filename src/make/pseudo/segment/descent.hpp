#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace batten::pseudo {

template <std::size_t N>
using Vector = std::array<double, N>;
template <std::size_t N>
using Matrix = std::array<std::array<double, N>, N>;

/// A function's value, gradient and Hessian at a point.
template <std::size_t N>
struct Quadratic {
    double value = 0;
    Vector<N> gradient{};
    Matrix<N> hessian{};
};

enum class DescentStatus {
    converged,     // Newton's step has shrunk to the rounding error of the gradient
    out_of_steps,  // 100 evaluations did not suffice
    no_start       // the function is infinite at the start
};

template <std::size_t N>
struct Descent {
    Vector<N> at{};
    Quadratic<N> last;
    DescentStatus status = DescentStatus::out_of_steps;
    int evaluations = 0;
};

/// Solves (H + shift I) p = -g by Cholesky; nothing if the matrix is not positive definite.
template <std::size_t N>
std::optional<Vector<N>> shifted_newton_step(const Quadratic<N>& f, double shift) {
    Matrix<N> l = f.hessian;
    Vector<N> p{};
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = l[i][j] + (i == j ? shift : 0.0);
            for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
            if (i == j && !(sum > 0)) return std::nullopt;
            l[i][j] = i == j ? std::sqrt(sum) : sum / l[j][j];
        }
        double sum = -f.gradient[i];
        for (std::size_t k = 0; k < i; ++k) sum -= l[i][k] * p[k];
        p[i] = sum / l[i][i];
    }
    for (std::size_t i = N; i-- > 0;) {
        for (std::size_t k = i + 1; k < N; ++k) p[i] -= l[k][i] * p[k];
        p[i] /= l[i][i];
    }
    return p;
}

template <std::size_t N>
double longest_entry(const Vector<N>& p) {
    double longest = 0;
    for (double entry : p) longest = std::fmax(longest, std::fabs(entry));
    return longest;
}

template <std::size_t N>
struct RestrainedStep {
    Vector<N> step;
    bool is_newton;  // Newton's own, to a minimum near enough
};

/// The Newton step with the smallest tried shift that makes it a descent no longer than `radius`.
///
/// The first shift keeps directions still in which the function is flat to rounding: a curvature of
/// 1e-14 of the largest is noise, one of 1e-11 still gets 0.99 of its Newton step.
template <std::size_t N>
RestrainedStep<N> restrained_step(const Quadratic<N>& f, double radius) {
    double trace = 0;
    for (std::size_t i = 0; i < N; ++i) trace += std::fabs(f.hessian[i][i]);
    const double unit = trace + longest_entry<N>(f.gradient) / radius;
    const double first_shift = 1e-13 * trace;
    double shift = first_shift;
    while (true) {
        const auto p = shifted_newton_step<N>(f, shift);
        if (p && longest_entry<N>(*p) <= radius) return {*p, shift == first_shift};
        shift = std::fmax(1e-9 * unit, 4 * shift);
    }
}

template <std::size_t N>
double predicted_decrease(const Quadratic<N>& f, const Vector<N>& p) {
    double decrease = 0;
    for (std::size_t i = 0; i < N; ++i) {
        double row = f.gradient[i];
        for (std::size_t j = 0; j < N; ++j) row += 0.5 * f.hessian[i][j] * p[j];
        decrease -= row * p[i];
    }
    return decrease;
}

template <std::size_t N>
Vector<N> moved(const Vector<N>& x, const Vector<N>& p) {
    Vector<N> y = x;
    for (std::size_t i = 0; i < N; ++i) y[i] += p[i];
    return y;
}

/// A local minimum of a positive function by Newton's method in a trust region, all variables of
/// order 1.
///
/// Aim: the position to the rounding error of gradient / curvature. Once the promised decrease is
/// near the rounding error of the value, plain Newton steps are made until they no longer shrink,
/// 40 at most, for the gradient knows the place better than the value.
/// Cost: 6 to 20 evaluations from a sensible start.
template <std::size_t N, class Expand>
Descent<N> descend(Expand&& expand, const Vector<N>& start) {
    constexpr double noise = 1e-13;
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    constexpr int most_evaluations = 100;
    constexpr int most_final_steps = 40;
    constexpr double close = 1e-5;
    Descent<N> d{start, expand(start), DescentStatus::out_of_steps, 1};
    if (!std::isfinite(d.last.value)) {
        d.status = DescentStatus::no_start;
        return d;
    }
    double radius = 0.5;
    double length_before = std::numeric_limits<double>::infinity();
    int final_steps = 0;
    while (d.evaluations < most_evaluations) {
        const auto [step, is_newton] = restrained_step<N>(d.last, radius);
        const double promised = predicted_decrease<N>(d.last, step);
        const double length = longest_entry<N>(step);
        const bool is_final = is_newton && promised <= noise * d.last.value;
        const bool is_flat = !is_newton && promised <= 0.1 * epsilon * d.last.value;
        const bool has_stalled = length < close && !(length < 0.5 * length_before);
        if (is_flat || (is_final && (has_stalled || final_steps == most_final_steps))) {
            d.status = DescentStatus::converged;
            return d;
        }
        const Vector<N> at = moved<N>(d.at, step);
        const Quadratic<N> fresh = expand(at);
        ++d.evaluations;
        if (is_final) {
            length_before = length;
            ++final_steps;
        } else {
            const double ratio = (d.last.value - fresh.value) / promised;
            if (ratio < 0.25 || !std::isfinite(fresh.value)) radius = 0.25 * length;
            if (ratio > 0.75) radius = std::fmin(std::fmax(radius, 2 * length), 1.0);
            if (!(ratio > 0)) continue;
        }
        d.at = at;
        d.last = fresh;
    }
    return d;
}

}  // namespace batten::pseudo
