#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "batten/base/tolerance.hpp"
#include "batten/shape/curve.hpp"
#include "measure/bezier/following.hpp"
#include "num/bernstein.hpp"

/// The numbers of a curve are taken from its pieces in Bernstein form.
namespace batten::bezier {

/// A curve as polynomial pieces in Bernstein form, in normal units: the first point is the origin
/// and the largest coordinate of a control point is between 1/2 and 1.
///
/// Pieces of polynomial curves are exact but for rounding, made from the derivatives at both of
/// their ends. Other curves are followed by polynomials of degree 7 that share value and three
/// derivatives with the curve at both ends and are halved until they agree with it between.
///
/// Laws: a curve times 2^k has the same pieces to the last bit, and unit() times 2^k.
/// Throws `curve.not-finite` where a value or derivative is not finite.
/// Cost: 2 jets a piece; about 2000 jets for a circle given by a callable.
class Pieces {
public:
    explicit Pieces(const Curve& curve);

    const Curve& curve() const { return curve_; }
    int dim() const { return dim_; }
    std::size_t size() const { return parts_.size(); }
    /// Degree of the positions, at least 1; the hodographs have one less.
    int degree() const { return degree_; }

    /// The piece of the curve that piece i is, or is a part of.
    std::size_t source(std::size_t i) const { return parts_[i].source; }
    Interval part(std::size_t i) const { return parts_[i].t; }
    /// The curve's parameter at u in [0, 1] of piece i; exact at both ends.
    double t_of(std::size_t i, double u) const;

    /// Bernstein coefficients of coordinate k of piece i, in normal units.
    std::span<const double> position(std::size_t i, int k) const;
    /// The same of the derivative in u.
    std::span<const double> hodograph(std::size_t i, int k) const;
    /// Bernstein coefficients of coordinate k less `value`, a number of the data, of piece i; in
    /// normal units. More exact than position() where the origin is far from the value.
    bernstein::Coefficients above(std::size_t i, int k, double value) const;
    /// The point at u of piece i.
    std::vector<double> point(std::size_t i, double u) const;

    /// The unit direction of motion at u of piece i; where it is at rest, that of the motion from
    /// there on (at u = 1: up to there). Empty for a piece that is a single point.
    std::vector<double> direction(std::size_t i, double u) const;

    /// The same pieces in the normal units of another curve, for comparisons. Throws
    /// `number.overflow` where they are too far apart for that.
    Pieces in_units_of(const Pieces& other) const;

    /// A point of the data in normal units. Coordinates may overflow to infinity.
    std::vector<double> to_normal(std::span<const double> point) const;
    /// The same. Throws `number.overflow` where the point is beyond 2^250 extents.
    std::vector<double> to_normal_near(std::span<const double> point) const;
    std::vector<double> to_data(std::span<const double> point) const;
    /// value x unit^power, where a normal unit is a power of two of data units. Throws
    /// `number.overflow` if that is beyond a double.
    double in_data(double value, int power) const;
    /// A tolerance for lengths, relative ones referring to extent(), in normal units.
    double in_normal(Tolerance tolerance) const;

    /// The longest side of the box around all control points, in normal units: 1/2 to 2, or 0.
    double extent() const { return extent_; }
    /// How far piece i is from the curve, in normal units: twice the largest distance seen where
    /// it is followed, 0 for polynomial curves.
    double defect(std::size_t i) const { return parts_[i].defect; }
    /// An ulp of the largest coordinate, in normal units: large where the origin is far away.
    double rounding() const { return rounding_; }

private:
    void fill();
    void normalise();
    std::size_t position_start(std::size_t i, int k) const;
    std::size_t hodograph_start(std::size_t i, int k) const;

    Curve curve_;
    int dim_, degree_;
    std::vector<Part> parts_;
    std::vector<double> block_;   // for each piece dim positions, then dim hodographs
    std::vector<double> origin_;  // in data units x 2^-shrink_
    int shrink_ = 0, exponent_ = 0;
    double extent_ = 0, rounding_ = 0;
};

/// Throws `option.range` unless the tolerance is a positive, finite number.
void require_tolerance(Tolerance tolerance);

}  // namespace batten::bezier
