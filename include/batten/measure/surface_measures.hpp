#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/measure/measured.hpp"
#include "batten/shape/surface.hpp"

namespace batten {

/// A number of a surface and where it is.
struct SurfacePlace {
    double value = 0;
    double x = 0, y = 0;
};

template <class Visit>
void visit_fields(const SurfacePlace& r, Visit&& visit) {
    visit("value", r.value, "the number");
    visit("x", r.x, "where it is");
    visit("y", r.y, "where it is");
}

struct SurfaceRange {
    SurfacePlace least, largest;
};

template <class Visit>
void visit_fields(const SurfaceRange& r, Visit&& visit) {
    visit("least", r.least, "the least and where it is");
    visit("largest", r.largest, "the largest and where it is");
}

/// The numbers of a surface z = S(x, y).
struct SurfaceReport {
    std::vector<double> domain;
    double integral = 0;
    std::optional<double> area, area_error;
    SurfaceRange height, gaussian_curvature, mean_curvature;
    std::vector<std::string> notes;
    Status status = Status::met;
};

template <class Visit>
void visit_fields(const SurfaceReport& r, Visit&& visit) {
    visit("domain", r.domain, "x0, x1, y0, y1");
    visit("integral", r.integral, "the volume between the surface and z = 0, signed");
    visit("area", r.area, "area of the graph");
    visit("area_error", r.area_error, "estimate of its error");
    visit("height", r.height, "range of the heights");
    visit("gaussian_curvature", r.gaussian_curvature, "range of the Gaussian curvature");
    visit("mean_curvature", r.mean_curvature, "range of the mean curvature; up is positive");
    visit("notes", r.notes, "why numbers are missing");
}

/// The area of the graph over the domain. Patches are halved both ways until two Gauss rules, 8 x 8
/// nodes on a patch and on its quarters, agree within the patch's share of `tolerance` (relative:
/// of the area of the domain), at most 5 times.
///
/// Patches lie between neighbouring knot lines, curved ones too; walls where a surface jumps are no
/// part of the graph. Where the slopes are beyond 1e150, infinite.
Measured surface_area(const Surface& surface, Tolerance tolerance = relative(1e-9));

/// All numbers at once. Ranges: of every patch a lattice of 5 x 5 places, for curvatures of 13 x 13;
/// from each of its local bests steps along and across, halved until they are 1e-9 of a patch. Left
/// out are those that half of what their patch spans would not raise to the best. Second derivatives
/// are those of the patch to the right where knots make them jump.
///
/// `not_met` where the area's error is beyond `tolerance`. Cost: about 500 evaluations a patch, 150 a climb.
SurfaceReport measure_surface(const Surface& surface, Tolerance tolerance = relative(1e-9));

}  // namespace batten
