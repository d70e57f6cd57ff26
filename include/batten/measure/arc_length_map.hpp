#pragma once

#include <memory>
#include <span>

#include "batten/base/tolerance.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

namespace arc {
class Sections;
}

/// Arc length s and parameter t of a whole curve, from one to the other; in any dimension.
///
/// Aim:    |s(t_of(s)) - s| and |s_of(t) - s(t)| <= tolerance + 2^-50 length. Relative tolerances
///         refer to the length. Judged in s: where the curve stands still, t is known no better
///         than the tolerance says. Ends are exact: 0 <-> domain lo, length <-> domain hi.
/// Holds at cusps, at ends passed with zero speed and on lines that are retraced.
/// Laws:   points times 2^k give 2^k times the arc lengths and the same parameters, exactly.
/// Cost:   a plain cubic curve: its lengths to make (20 ns a gentle piece), and 2 us more for each
///         piece, once, when a question first falls on it (14 us one of random control points);
///         others all of it at once. Then 200 ns a question, 25 ns one of many rising arc lengths.
///         Some 600 bytes a piece asked for. Threads may ask one map at once.
/// Throws: `option.range` unless the tolerance is above 0; `curve.no-length` for a single point;
///         `curve.not-finite`; `number.overflow`.
/// Source: on each of its cells the inverse is a Chebyshev sum, found by Newton's method from that
///         of the speed; a cell that needs more than 24 terms is halved [Trefethen2013, chapter 4].
class ArcLengthMap {
public:
    explicit ArcLengthMap(const Curve& curve, Tolerance tolerance = relative(1e-12));

    double length() const;
    /// Bound on the error of the length, as the convergence of the sums tells it.
    double error() const;
    /// The places where two cells meet, in t, both ends of the domain included. Asks all pieces.
    std::span<const double> joints() const;

    /// Throws `curve.outside` unless 0 <= s <= length(), or t lies in the domain.
    double t_of(double s) const;
    double s_of(double t) const;
    /// Many at once. Rising arc lengths cost O(cells + numbers); others a search each.
    void t_of(std::span<const double> s, std::span<double> t) const;

private:
    std::shared_ptr<const arc::Sections> sections_;
};

}  // namespace batten
