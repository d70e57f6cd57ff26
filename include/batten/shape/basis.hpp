#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"

namespace batten {

/// The B-splines of one degree over one knot vector: scalar functions of t, ignorant of dimension.
///
/// Function j lives on [knots()[j], knots()[j + degree + 1]] and is positive inside. On span s,
/// [knots()[s], knots()[s + 1]] of positive length, the degree + 1 functions s - degree ... s are
/// not zero; in a periodic basis function j is the control point j modulo size().
///
/// Laws: (1) the functions are >= 0 and add up to 1 within a few ulps
///       (2) knots x 2^k give the same values, exactly
/// Immutable; an invalid one cannot exist.
class BSplineBasis {
public:
    static constexpr int most_degree = 25;

    /// From the full knot vector, ends repeated degree + 1 times.
    ///
    /// Throws `bspline.degree` unless 0 <= degree <= most_degree, `bspline.knots` unless the knots
    /// are finite and do not decrease, both ends are repeated degree + 1 times and inner knots at
    /// most degree times (once for degree 0).
    BSplineBasis(std::vector<double> knots, int degree);

    /// The same from the breaks, every inner one a simple knot.
    static BSplineBasis over(std::span<const double> breaks, int degree);

    /// Periodic, from the knots of one period: its start (repeated or not) up to its end, which is
    /// the start again and stands once. knots() is that list continued by `degree` knots at both
    /// ends; there are as many functions as knots in the period, the end not counted.
    ///
    /// Throws as above; degree >= 1.
    static BSplineBasis periodic(std::span<const double> knots, int degree);

    int degree() const { return degree_; }
    bool is_periodic() const { return periodic_; }
    /// How many functions there are.
    std::size_t size() const;
    std::span<const double> knots() const { return knots_; }
    /// The distinct knots of the domain.
    std::span<const double> breaks() const { return breaks_; }
    Interval domain() const { return {breaks_.front(), breaks_.back()}; }

    /// The span that holds t: right-continuous, except at the end of the domain. Parameters
    /// outside belong to the first or last span. Cost: a binary search.
    std::size_t span_of(double t) const;
    /// The span between breaks()[piece] and breaks()[piece + 1].
    std::size_t span_of_piece(std::size_t piece) const { return spans_[piece]; }
    /// The control point that function `function` of span `span` (0 ... degree) belongs to.
    std::size_t control(std::size_t span, int function) const;

    /// Values and derivatives up to `order` of the functions that are not zero on span_of(t):
    /// `out` gets order + 1 rows of degree + 1 numbers. No allocation.
    void nonzero(double t, int order, std::span<double> out) const {
        nonzero_on(span_of(t), t, order, out);
    }
    /// The same for the polynomials of a given span: one-sided limits at its ends.
    ///
    /// Source: de Boor's recurrences for values and derivatives [DeBoor2001, X(9) and X(15)].
    void nonzero_on(std::size_t span, double t, int order, std::span<double> out) const;

    /// One parameter a function: the mean of its inner knots, where it is near its largest; in a
    /// periodic basis brought into the domain. The middle of its span for degree 0.
    /// Law: sum of greville()[j] x function j is t (not periodic, degree >= 1).
    std::vector<double> greville() const;

    bool operator==(const BSplineBasis&) const = default;

private:
    BSplineBasis(std::vector<double> knots, int degree, bool is_periodic_basis);

    std::vector<double> knots_;
    std::vector<double> breaks_;
    std::vector<std::size_t> spans_;
    int degree_;
    bool periodic_;
};

}  // namespace batten
