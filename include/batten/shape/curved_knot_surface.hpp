#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/shape/spline_function.hpp"
#include "batten/shape/spline_surface.hpp"

namespace batten {

/// One cell between knot lines: numbers of the intervals in x and in y, from 0.
struct KnotCell {
    /// The interval that holds the place.
    static constexpr std::size_t found = static_cast<std::size_t>(-1);

    std::size_t x = found, y = found;
};

/// A spline surface whose knot lines are curves: z = sum of c(i, j) N_i(x; Dx(y)) N_j(y; Dy(x)).
///
/// Dx(y) holds the ends of the x-domain, degree + 1 times, and X_1(y) ... X_n(y); Dy(x) likewise.
/// Lines may touch and leave each other again: where m of them run together the derivative of
/// order degree + 1 - m jumps across; where degree + 1 do, the surface itself. Lines that would
/// cross exchange their places; parts outside the domain lie on its border; lines nearer than
/// 1e-12 of the domain run together.
/// Immutable; an invalid one cannot exist.
/// Source: [Hatano, section 4], with the order of the jumping derivative corrected.
class CurvedKnotSurface {
public:
    /// Derivatives up to this order in all.
    static constexpr int most_derivatives = 9;

    /// `x_lines` are functions of y over the y-domain, `y_lines` of x over the x-domain;
    /// `coefficients`: (x_lines + degree + 1) rows of (y_lines + degree + 1) numbers.
    ///
    /// Throws `surface.degree` unless 0 <= degree <= 25, `surface.lines` where a line does not
    /// cover the domain or the domain is empty, `surface.coefficients` unless there are so many
    /// and all are finite.
    CurvedKnotSurface(int degree, const Rectangle& domain, std::vector<SplineFunction> x_lines,
                      std::vector<SplineFunction> y_lines, std::vector<double> coefficients);

    int degree() const { return degree_; }
    const Rectangle& domain() const { return domain_; }
    std::span<const SplineFunction> x_lines() const { return x_lines_; }
    std::span<const SplineFunction> y_lines() const { return y_lines_; }
    std::span<const double> coefficients() const { return coefficients_; }

    /// The height, or a derivative; right-continuous in x and y, except at the upper ends. Places
    /// outside the domain are moved to its border.
    ///
    /// Throws `surface.derivative` beyond `most_derivatives`.
    /// Accuracy: the recurrences of the B-splines in truncated Taylor series, so that the chain
    /// rule through the lines is exact; rounding grows as gaps between lines shrink.
    /// Cost: an evaluation of every line, a sort of those, order^2 operations; about ten times as
    /// much with first and second derivatives.
    double operator()(double x, double y, Partial derivative = {}) const;
    /// Value, first and second derivatives at once.
    HeightJet jet(double x, double y) const { return jet_in({}, x, y); }

    /// The same of the function in one cell, continued beyond its sides: one-sided limits there.
    /// A cell without width at the place gives way to the one that holds it.
    double value_in(KnotCell cell, double x, double y) const;
    HeightJet jet_in(KnotCell cell, double x, double y) const;

    /// The ends of the x-domain and between them the lines at `y`, rising: interval number i of a
    /// cell lies between entries i and i + 1. Those that run together are equal.
    std::vector<double> x_knots(double y) const;
    std::vector<double> y_knots(double x) const;

    /// The same surface with x and y exchanged.
    CurvedKnotSurface transposed() const;

    bool operator==(const CurvedKnotSurface&) const = default;

private:
    int degree_;
    Rectangle domain_;
    std::vector<SplineFunction> x_lines_, y_lines_;
    std::vector<double> coefficients_;
};

/// Whether all lines are constants.
bool are_straight(std::span<const SplineFunction> lines);

/// The double integral over a part of the domain. Throws `surface.outside`.
///
/// Accuracy: exact but for rounding in the direction that crosses the curved lines, by Gauss rules
/// along them, halved until 1e-12 of the largest coefficient times the area: exact too but for
/// rounding where lines neither cross nor leave the part. Where lines of both directions are
/// curved, 4e-9 as of sections.
double integral(const CurvedKnotSurface& surface, const Rectangle& part);
double integral(const CurvedKnotSurface& surface);

/// S(x, y) along one line of constant y, or of constant x; jumps are kept as knots that stand
/// degree + 1 times. Throws `surface.outside`.
///
/// Exact, of the surface's own degree, where the cut crosses curved lines and runs along straight
/// ones. The other way it is no polynomial: pieces of degree 5 with its heights and first and
/// second derivatives at their ends, within 1e-9 of the largest coefficient.
SplineFunction section_at_y(const CurvedKnotSurface& surface, double y);
SplineFunction section_at_x(const CurvedKnotSurface& surface, double x);

}  // namespace batten
