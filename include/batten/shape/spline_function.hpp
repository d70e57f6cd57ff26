#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/shape/curve.hpp"
#include "batten/shape/piecewise_cubic.hpp"

namespace batten {

/// A scalar spline y(x) of any degree: knots t, coefficients c, as in SciPy's `BSpline(t, c, k)`.
///
/// S(x) = sum of c[j] N_j(x) over the domain [t[degree], t[size of c]]; outside, the first and the
/// last polynomial are continued. Right-continuous, except at the end of the domain.
/// Immutable; an invalid one cannot exist.
class SplineFunction {
public:
    /// Throws `spline.degree` unless 0 <= degree <= 25, `spline.knots` unless the knots are finite,
    /// do not decrease, are one more than degree + coefficients, repeat at most degree + 1 times
    /// and span a domain of positive length; `spline.coefficients` unless those are finite.
    SplineFunction(std::vector<double> knots, std::vector<double> coefficients, int degree);

    /// Periodic, from knots and coefficients of the same form that repeat after the domain's
    /// length: only a flag, `is_closed()`.
    static SplineFunction periodic(std::vector<double> knots, std::vector<double> coefficients,
                                   int degree);

    int degree() const { return degree_; }
    std::span<const double> knots() const { return knots_; }
    std::span<const double> coefficients() const { return coefficients_; }
    std::span<const double> breaks() const { return breaks_; }
    std::size_t pieces() const { return breaks_.size() - 1; }
    Interval domain() const { return {breaks_.front(), breaks_.back()}; }
    bool is_closed() const { return closed_; }

    /// The piece that holds x. Cost: a table look-up, whatever the number of pieces.
    std::size_t piece_of(double x) const;
    /// The value, or a derivative, at x.
    double operator()(double x, int derivative = 0) const {
        return value_on(piece_of(x), x, derivative);
    }
    /// The same for one piece: at its ends the one-sided limits.
    double value_on(std::size_t piece, double x, int derivative) const;
    /// Many abscissae at once, in any order, sorted ones fastest. No allocation.
    void evaluate(std::span<const double> x, int derivative, std::span<double> out) const;
    /// Value, first and second derivative at once: x.size() numbers each.
    void evaluate_jets(std::span<const double> x, std::span<double> value,
                       std::span<double> first, std::span<double> second) const;

    /// On piece i, with u = x - breaks()[i], S = sum of power(j)[i] u^j: the power form.
    std::span<const double> power(int j) const {
        return std::span(power_).subspan(static_cast<std::size_t>(j) * pieces(), pieces());
    }

    bool operator==(const SplineFunction& other) const {
        return degree_ == other.degree_ && closed_ == other.closed_ && knots_ == other.knots_ &&
               coefficients_ == other.coefficients_;
    }

private:
    void build_pieces();
    void build_guide();

    std::vector<double> knots_, coefficients_, breaks_, power_;
    std::vector<std::size_t> spans_;
    std::vector<unsigned> guide_;
    double guide_scale_ = 0;
    int degree_ = 3;
    bool closed_ = false;
};

/// dS/dx, of one degree less (a spline of degree 0 has the derivative 0, degree 0).
SplineFunction derivative(const SplineFunction& spline);
/// The integral from the start of the domain: one degree more.
SplineFunction antiderivative(const SplineFunction& spline);
/// The integral over [part.lo, part.hi]; outside the domain the end polynomials count.
double integral(const SplineFunction& spline, Interval part);

/// Where the spline crosses `level` in its domain, rising. Of a stretch that lies on the level whole
/// only its inner ends are listed; a touching is found where rounding lets it be a crossing or zero.
///
/// Accuracy: a few ulps of x at simple roots. Cost: Bernstein bounds and bisection, then
/// `num::find_root`.
std::vector<double> roots(const SplineFunction& spline, double level = 0);
/// Where the derivative changes sign, inside the domain, rising.
std::vector<double> extrema(const SplineFunction& spline);

/// The same spline with more knots. Throws `spline.knots` for a knot outside the open domain, or
/// one that would stand more than degree + 1 times. Not for periodic splines: they are opened.
SplineFunction insert_knots(const SplineFunction& spline, std::span<const double> knots);
/// The same spline with its ends clamped: knots repeated degree + 1 times there.
SplineFunction clamped(const SplineFunction& spline);

struct KnotRemoval {
    SplineFunction spline;
    double max_error = 0;  ///< bound of the change anywhere; 0 up to rounding for a spare knot
};
/// The spline without `knots()[index]`, an interior one, its coefficients those of the least
/// squared change. Throws `spline.knots` for an index that is not interior.
KnotRemoval remove_knot(const SplineFunction& spline, std::size_t index);

/// The same spline as one of a higher degree. Throws `spline.degree` beyond 25.
SplineFunction elevate_degree(const SplineFunction& spline, int by = 1);

/// The graph x(t) = t, y(t) = S(t) as a curve. Throws `spline.not-continuous` where a knot is
/// repeated degree + 1 times inside, or for degree 0.
Curve graph(const SplineFunction& spline);
/// The graph as cubic pieces; throws `spline.degree` for degree 4 and more.
PiecewiseCubic graph_cubic(const SplineFunction& spline);

}  // namespace batten
