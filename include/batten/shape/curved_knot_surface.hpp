#pragma once

#include <span>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/shape/spline_function.hpp"
#include "batten/shape/spline_surface.hpp"

namespace batten {

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

    /// The height; right-continuous in x and y, except at the upper ends. Places outside the
    /// domain are moved to its border.
    /// Cost: an evaluation of every line, a sort of those, order^2 operations.
    double operator()(double x, double y) const;

private:
    int degree_;
    Rectangle domain_;
    std::vector<SplineFunction> x_lines_, y_lines_;
    std::vector<double> coefficients_;
};

}  // namespace batten
