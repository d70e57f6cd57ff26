#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/shape/basis.hpp"
#include "batten/shape/piecewise_cubic.hpp"

namespace batten {

/// A B-spline curve: control points, and positive weights where it is rational.
///
/// A periodic basis makes a closed curve; its first control point is not repeated.
/// Immutable; an invalid one cannot exist.
class BSplineCurve {
public:
    /// Throws `bspline.degree` for degree 0 (a curve has no jumps), `bspline.control-points`
    /// unless there is one a function, `points.not-finite`, `bspline.weights` unless there are
    /// none or one positive finite weight a control point.
    BSplineCurve(BSplineBasis basis, Points control_points, std::vector<double> weights = {});

    const BSplineBasis& basis() const { return basis_; }
    PointsView control_points() const { return control_points_; }
    bool is_rational() const { return !weights_.empty(); }
    /// Empty unless rational.
    std::span<const double> weights() const { return weights_; }

    int dim() const { return control_points_.dim(); }
    /// The distinct knots.
    std::span<const double> breaks() const { return basis_.breaks(); }
    bool is_closed() const { return basis_.is_periodic(); }
    /// Nothing where rational.
    std::optional<int> degree() const {
        return is_rational() ? std::nullopt : std::optional(basis_.degree());
    }
    /// Value and derivatives on one piece; see `CurveShape`. No allocation.
    /// Source: [PieglTiller1997, eq. 3.3 and 4.8].
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const;

    bool operator==(const BSplineCurve&) const = default;

private:
    BSplineBasis basis_;
    Points control_points_;
    std::vector<double> weights_;
};

/// The same curve with `knots` added, in any order, repeated for multiplicity; for a closed curve
/// also at its start.
///
/// Control points that no new knot reaches stay the same bits; the others are within a few ulps of
/// the largest control point near. Throws `curve.outside` for a knot outside the domain (or at the
/// end of an open one), `bspline.knots` for one that would stand too often.
/// Source: blossoming [Ramshaw1989].
BSplineCurve insert_knots(const BSplineCurve& curve, std::span<const double> knots);

/// The same curve, its degree raised by `by` >= 1. Throws `bspline.degree` beyond
/// BSplineBasis::most_degree. Cost: O(degree^3) a control point and raise.
/// Source: blossoming [Ramshaw1989].
BSplineCurve elevate_degree(const BSplineCurve& curve, int by = 1);

/// The same curve as cubic pieces between the distinct knots, to a few ulps.
/// Throws `bspline.degree` for degree 4 and more, `bspline.weights` where it is rational.
PiecewiseCubic to_piecewise_cubic(const BSplineCurve& curve);

/// The cubic B-spline curve of `curve`: derivatives up to continuity[i] (0, 1 or 2) are taken as
/// continuous at joint i, one a joint between two pieces: breaks 1, 2, ... of an open curve;
/// breaks 0, 1, 2, ... of a closed one. Joint i becomes a knot 3 - continuity[i] times.
///
/// What does not have the continuity stated comes out changed: ask
/// `continuity` of batten/measure for what a curve has. Throws `bspline.continuity` where the list
/// has the wrong length or another number.
BSplineCurve to_bspline(const PiecewiseCubic& curve, std::span<const int> continuity);

}  // namespace batten
