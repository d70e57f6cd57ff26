#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/curve.hpp"
#include "batten/shape/piecewise_cubic.hpp"

namespace batten {

/// What a curve can be turned into.
enum class Form {
    same,      ///< as it is
    cubic,     ///< cubic pieces; exact where the pieces are polynomials of degree 3 or less
    quintic,   ///< pieces of degree 5 with the curve's second derivatives at their ends
    arcs,      ///< circular arcs and lines, few of them; plane curves only
    polyline,  ///< straight pieces
    power,     ///< the polynomials of its pieces, as rows: `power_form`
};

constexpr std::array<Named<Form>, 6> names_of(Form) {
    return {{{"same", Form::same},
             {"cubic", Form::cubic},
             {"quintic", Form::quintic},
             {"arcs", Form::arcs},
             {"polyline", Form::polyline},
             {"power", Form::power}}};
}

struct ConvertOptions {
    Form as = Form::same;
    Tolerance tolerance = relative(1e-6);
    bool reverse = false;
    std::optional<Interval> trim;
    std::optional<double> scale;
    std::vector<double> insert_knots;
    int elevate = 0;
    bool remove_knots = false;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, ConvertOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("as", o.as, anything, "the form to turn the curve into");
    visit("tolerance", o.tolerance, more_than(0),
          "largest distance of the new form from the curve; 1e-6r is relative to its extent");
    visit("reverse", o.reverse, anything, "run through the points in the opposite direction");
    visit("trim", o.trim, anything, "keep the part between these two parameters");
    visit("scale", o.scale, anything, "multiply all coordinates by this number");
    visit("insert_knots", o.insert_knots, anything,
          "as a B-spline with these knots more, repeated for multiplicity");
    visit("elevate", o.elevate, between(0, 25), "as a B-spline of a degree so much higher");
    visit("remove_knots", o.remove_knots, anything,
          "as a B-spline without the knots that it can do without, within the tolerance");
}

struct ConvertReport {
    double max_error = 0;
    std::size_t pieces = 0;
    std::optional<std::size_t> removed;
    Status status = Status::met;
};

template <class Visit>
void visit_fields(const ConvertReport& r, Visit&& visit) {
    visit("max_error", r.max_error, "largest distance of the new form from the curve");
    visit("pieces", r.pieces, "number of pieces of the result");
    if (r.removed) visit("removed", r.removed, "knots that were taken out");
}

struct Conversion {
    Curve curve;
    ConvertReport report;
};

/// Trims, reverses, scales, changes the form of `curve`, inserts knots, elevates, removes knots: in
/// this order. The power form is the curve itself, once it is known to have one.
///
/// `max_error` is measured at 16 parameters of each new piece, same parameter against same
/// parameter, so it bounds the distance from above at those places; for arcs it is the distance
/// `batten::arcs` reports. A chain of arcs stays one when it is trimmed, reversed or scaled.
/// Throws what `batten::arcs` throws and `curve.outside`, `curve.part-empty`, `curve.scale`, `option.range` for a tolerance that
/// is not above 0, `curve.not-exact`, and of knots and degrees what insert_knots, elevate_degree and
/// remove_knots throw.
Conversion convert(const Curve& curve, const ConvertOptions& options);

/// `curve` as cubic pieces: exact (Taylor) where degree() <= 3, else Hermite pieces halved until
/// they are within `tolerance` (data units). Cost: 5 evaluations a piece tried.
PiecewiseCubic to_piecewise_cubic(const Curve& curve, double tolerance);

/// `curve` as a B-spline of degree 5: exact (up to rounding) where degree() <= 5, else pieces that
/// have its value and its first two derivatives at their ends, halved until they are within
/// `tolerance` (data units). Twice continuously differentiable where the curve is, knots standing
/// three times; five times where its first or second derivative jumps.
/// Cost: 5 evaluations a piece tried. Source: blossoming [Ramshaw1989].
BSplineCurve to_quintic(const Curve& curve, double tolerance);

/// `curve` as a B-spline: one as it is; pieces of degree 3 or less with knots as often as the
/// derivatives that `continuity` finds leave them. Throws `curve.not-exact` for all others.
BSplineCurve to_bspline(const Curve& curve);

/// `curve` without the inner knots, tried one after the other, that it can do without: their bounds
/// of change (see `KnotRemoval`) sum up to at most `tolerance` (data units).
/// Throws `bspline.removal` where it is closed or rational. Cost: O(knots^2).
BSplineCurve remove_knots(const BSplineCurve& curve, double tolerance);

/// One row a piece: where it starts and ends, then for each coordinate the coefficients of
/// (t - start)^0, (t - start)^1, ... Throws `curve.not-exact` unless the pieces are polynomials.
Points power_form(const Curve& curve);

/// The vertices of a polyline within `tolerance` (data units) of `curve`, its joints among them.
Points to_polyline(const Curve& curve, double tolerance);

}  // namespace batten
