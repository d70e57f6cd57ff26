#pragma once

#include <array>
#include <concepts>
#include <type_traits>
#include <vector>

#include "batten/shape/curve.hpp"

namespace batten {

/// A line of the plane, endless in both directions.
struct Line {
    std::array<double, 2> point{};
    std::array<double, 2> direction{1, 0};  ///< of any length but 0
};

/// Where a curve meets a line.
struct LineIntersection {
    double t = 0;
    std::array<double, 2> point{};
    double along = 0;  ///< from the line's point in its direction, in data units
};

template <class Report, class Visit>
    requires std::same_as<std::remove_const_t<Report>, LineIntersection>
void visit_fields(Report& r, Visit&& visit) {
    visit("t", r.t, "parameter on the curve");
    visit("point", r.point, "where the two meet");
    visit("along", r.along, "distance from the line's point in its direction");
}

/// All places where a plane curve crosses or touches a line, in the order of t. A piece that lies
/// in the line contributes its two ends; the seam of a closed curve is listed once.
///
/// Aim:    no crossing is missed; t within rounding of the coordinates / speed across the line.
/// Throws: `curve.dimension` unless the curve is plane, `line.direction` where that is zero or not
///         finite, `points.not-finite`; `curve.not-finite`.
/// Source: the zeros of a polynomial on each piece [Farouki2012].
std::vector<LineIntersection> line_intersections(const Curve& curve, const Line& line);

}  // namespace batten
