#pragma once

#include <limits>
#include <vector>

#include "batten/shape/curve.hpp"
#include "make/arcs/fewest.hpp"

/// Arcs along a curve of the plane.
namespace batten::arc_spline {

struct CurveTask {
    const Curve& curve;
    double tolerance = 0;  ///< data units
    double max_radius = std::numeric_limits<double>::infinity();
};

/// The parameters where the tangent of a curve turns by more than 1e-6 rad at once, and both ends
/// of the domain.
std::vector<double> corners(const Curve& curve);

/// The parameters inside the pieces where the curvature is locally largest or smallest; found
/// among 16 places of each piece, placed to about a thousandth of it.
std::vector<double> curvature_extrema(const Curve& curve);

/// A biarc over each part between two of `joints` (rising, among them both ends of the domain and
/// all corners), with the curve's own tangents; a line where no biarc exists, both halves where the
/// part ends where it starts.
Row biarcs_between(const CurveTask& task, const std::vector<double>& joints);

/// The longest biarcs within the tolerance, one after the other, that do not pass over a `stop`
/// (rising, among them both ends of the domain and all corners). A line where a biarc
/// fails and the line does not; parts shorter than 2^-40 of the domain are taken as they come.
///
/// Cost: about 12 trials a biarc, each about 40 evaluations of the curve (see CurveDistance).
Row longest_biarcs(const CurveTask& task, const std::vector<double>& stops);

/// The longest biarcs with the fewest moves among four choices of stops: corners alone, or also
/// the curvature's extrema, the breaks, or both.
Row fewest_biarcs(const CurveTask& task);

/// How far the curve between its parameters `joints` is from `arcs`, one arc for each part.
std::vector<double> arc_errors(const Curve& curve, const std::vector<Arc>& arcs,
                               const std::vector<double>& joints);

}  // namespace batten::arc_spline
