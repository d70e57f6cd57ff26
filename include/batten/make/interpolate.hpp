#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/make/interpolate_options.hpp"
#include "batten/measure/curvature.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// What came of it, in data units and radians. A number that does not exist is absent, with a note.
struct InterpolateReport {
    double length = 0;
    double length_error = 0;
    std::optional<double> area;
    std::optional<double> pseudo_energy;
    std::optional<double> bending_energy;
    std::optional<double> energy_length;
    std::optional<MaxCurvature> max_curvature;
    std::optional<std::vector<double>> tangent_angles;
    std::optional<std::vector<double>> tangent_angles_in;
    std::vector<std::string> notes;
    /// not_converged: pseudo-spline-global has reached its last step before its gradient vanished.
    /// not_met: an arc-chain does not close smoothly; log-aesthetic has kept tangents at 137 degrees
    /// to a chord, where curvatures jump.
    Status status = Status::met;
};

template <class Report, class Visit>
requires std::same_as<std::remove_const_t<Report>, InterpolateReport>
void visit_fields(Report& r, Visit&& visit) {
    visit("length", r.length, "arc length");
    visit("length_error", r.length_error, "bound on the error of the length");
    visit("area", r.area,
          "signed area, counter-clockwise positive; an open curve is closed by its chord");
    visit("pseudo_energy", r.pseudo_energy,
          "sum over the spans of bending energy times length squared");
    visit("bending_energy", r.bending_energy, "integral of curvature squared over arc length");
    visit("energy_length", r.energy_length, "bending energy times length: free of scale");
    visit("max_curvature", r.max_curvature, "largest curvature, and where");
    visit("tangent_angles", r.tangent_angles,
          "direction at each point, in (-pi, pi]; at a corner of the outgoing side");
    visit("tangent_angles_in", r.tangent_angles_in,
          "direction in which each point is reached, where there are corners");
    visit("notes", r.notes, "what else there is to say");
}

/// A curve through points, and its measures.
struct Interpolation {
    Curve curve;
    InterpolateReport report;
};

/// The curve asked for through `points` (n rows, 2 columns; 3 for pseudo-spline; 2 and more for
/// hermite methods, 1 and more for splines and lagrange), with its measures. See
/// docs/interpolation.md.
///
/// Breaks: pseudo-spline, hermite and uniform: 0, 1, 2, ...; chord and centripetal: from 0 by their
/// steps; given parameters: these; pchip and makima: x; arc-chain and log-aesthetic: arc lengths.
/// Unless told, spline is by chords and lagrange uniform.
/// Laws:   (1) through the points, bit for bit
///         (2) points x 2^k (given parameters as they are): the curve x 2^k, exactly
///         (3) the mirror image (x, -y) exactly; reversal and rotation to rounding
///         (4) pseudo-spline, hermite, pchip: a moved point changes the two spans before and
///             behind it alone; makima: three
/// Closed: the first point is not repeated at the end; if it is, that is noted and left out.
/// Two points: a straight line by every method, unless a tangent is fixed.
/// Cost:   as `curve_through`, and some 20 us a span for the measures.
/// Throws: `points.dimension`; `points.too-few` below 2, closed below 3; `points.not-finite`,
///         `points.repeated`, `points.all-equal` (splines of one column by uniform or given
///         parameters may stand still); `number.overflow`; `interpolate.parameters` where given
///         ones are not finite and increasing or not one a point, or a chord vanishes beside the
///         sum; `interpolate.x-not-increasing`; for what the method does not take
///         `interpolate.closed-not-taken`, `interpolate.corner-not-taken`,
///         `interpolate.parameters-not-taken`, `interpolate.tangent-not-taken`; for indices that
///         are none `interpolate.corner-outside`, `interpolate.tangent-outside`,
///         `interpolate.part-outside`, `interpolate.part-empty`; `interpolate.tangent-repeated`,
///         `interpolate.tangent-at-corner`; `option.range` for the weight exponent or an angle.
Interpolation interpolate(PointsView points, const InterpolateOptions& options);

/// The curve alone. Cost: a spline about 15 ns a point, hermite methods 0.5 us, pseudo-spline
/// 1.2 ms.
Curve curve_through(PointsView points, const InterpolateOptions& options);

}  // namespace batten
