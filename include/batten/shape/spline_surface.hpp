#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "batten/base/grid.hpp"
#include "batten/base/interval.hpp"
#include "batten/shape/basis.hpp"
#include "batten/shape/spline_function.hpp"

namespace batten {

/// Which derivative: so often by x, so often by y.
struct Partial {
    int x = 0;
    int y = 0;

    bool operator==(const Partial&) const = default;
};

/// A height with its first and second derivatives.
struct HeightJet {
    double value = 0;
    double x = 0, y = 0;
    double xx = 0, xy = 0, yy = 0;
};

/// A part of the plane, sides parallel to the axes.
struct Rectangle {
    Interval x, y;

    bool operator==(const Rectangle&) const = default;
};

/// A tensor-product spline z = S(x, y) = sum of c(i, j) N_i(x) N_j(y), of any degree in x and y.
///
/// Outside the domain the polynomials at its border are continued. Right-continuous, except at the
/// upper ends. Immutable; an invalid one cannot exist.
/// Source: [DeBoor2001, XVII].
class SplineSurface {
public:
    /// `coefficients`: x_basis.size() rows of y_basis.size() numbers. Throws `surface.coefficients`
    /// unless there are so many and all are finite, `surface.basis` where a basis is periodic.
    SplineSurface(BSplineBasis x_basis, BSplineBasis y_basis, std::vector<double> coefficients);

    const BSplineBasis& x_basis() const { return x_; }
    const BSplineBasis& y_basis() const { return y_; }
    std::span<const double> coefficients() const { return coefficients_; }
    double coefficient(std::size_t i, std::size_t j) const {
        return coefficients_[i * y_.size() + j];
    }
    Rectangle domain() const { return {x_.domain(), y_.domain()}; }

    /// The value, or a derivative. Cost: two searches and order^2 operations.
    double operator()(double x, double y, Partial derivative = {}) const;
    /// Value, first and second derivatives at once.
    HeightJet jet(double x, double y) const;

    /// On the grid of rising abscissae `x` and ordinates `y`: out(r, s) = S(x[r], y[s]), y fastest,
    /// x.size() x y.size() numbers.
    ///
    /// Cost: order operations a node, plus order x y_basis.size() a row. Accuracy: a few ulps of
    /// the largest coefficient around the node, for derivatives of their differences.
    void evaluate(std::span<const double> x, std::span<const double> y, Partial derivative,
                  std::span<double> out) const;
    Grid evaluate(std::span<const double> x, std::span<const double> y,
                  Partial derivative = {}) const;

    bool operator==(const SplineSurface&) const = default;

private:
    BSplineBasis x_, y_;
    std::vector<double> coefficients_;
};

/// The double integral over a part of the domain: exact but for rounding. Throws
/// `surface.outside` where the domain does not contain `part`.
double integral(const SplineSurface& surface, const Rectangle& part);
double integral(const SplineSurface& surface);

/// S(x, y) along one line of constant y, or of constant x. Throws `surface.outside`.
SplineFunction section_at_y(const SplineSurface& surface, double y);
SplineFunction section_at_x(const SplineSurface& surface, double x);

/// One polynomial patch: Bezier heights over its rectangle, (x_degree + 1) rows of y_degree + 1.
struct BezierPatch {
    Rectangle part;
    std::vector<double> heights;
};

/// All patches between breaks, x slowest: exact but for rounding.
/// Source: the blossom at the corners of each piece [Ramshaw1989].
std::vector<BezierPatch> bezier_patches(const SplineSurface& surface);

/// `count` places evenly from lo to hi, both among them; count >= 2.
std::vector<double> even_places(Interval range, std::size_t count);

}  // namespace batten
