#pragma once

#include <optional>
#include <string>

#include "batten/batten.hpp"

/// The paper's curves A, B and C with a = 2 and b = 1 over t = 0 ... pi, and what was measured of
/// them.
namespace nakajima {

struct Example {
    char name;
    const char* formula;

    double x(double t) const;
    double y(double t) const;
    /// The height of the curve at this x, where it has one.
    std::optional<double> height(double x) const;
    /// The direction in which it starts.
    double start_angle() const;
    /// n + 1 points at equal steps of t.
    batten::Points points(int n) const;
    /// (y - height(x)) / b in percent: the paper's measure.
    std::optional<double> error(const std::vector<double>& p) const;
};

inline constexpr Example examples[] = {{'A', "x = 2 cos t, y = sin t"},
                                       {'B', "x = 4 t / π, y = sin t"},
                                       {'C', "x = 4 t / π, y = cos t"}};

/// A curve in n cells and its errors over t / pi: everywhere they exist, and at the paper's places.
struct ErrorCurve {
    std::vector<batten::Points> runs;
    batten::Points at_quarters = batten::Points(0, 2);
    double largest = 0;  ///< of those at the quarters, with its sign
};

/// `curve` has n pieces, from point to point.
ErrorCurve errors_of(const Example& example, const batten::Curve& curve);

batten::Curve lagrange_curve(const Example& example, int n, int degree);
batten::ArcChain arc_curve(const Example& example, int n);

}  // namespace nakajima
