#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/measure/continuity.hpp"
#include "batten/measure/curvature.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

struct MeasureOptions {
    Tolerance tolerance = relative(1e-12);
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, MeasureOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("tolerance", o.tolerance, more_than(0),
          "largest error of the length; 1e-12r is relative to the extent");
}

/// The numbers of a curve. Those that do not exist are empty, and `notes` says why.
struct MeasureReport {
    double length = 0;
    double length_error = 0;
    std::optional<double> area, area_error;
    std::optional<double> area_positive, area_negative;
    std::vector<double> centroid;
    std::optional<double> bending_energy, bending_energy_error;
    std::optional<double> energy_length;
    std::optional<double> pseudo_energy;
    std::optional<MaxCurvature> max_curvature;
    std::optional<double> turning;
    std::optional<std::vector<double>> inflections;
    std::vector<Joint> joints;
    std::vector<std::string> notes;
    Status status = Status::met;
};

template <class Report, class Visit>
    requires std::same_as<std::remove_const_t<Report>, MeasureReport>
void visit_fields(Report& r, Visit&& visit) {
    visit("length", r.length, "arc length");
    visit("length_error", r.length_error, "bound on its error");
    visit("area", r.area, "signed area, counter-clockwise positive; closed by the chord");
    visit("area_error", r.area_error, "bound on its error");
    visit("area_positive", r.area_positive, "area wound around to the left, by winding number");
    visit("area_negative", r.area_negative, "area wound around to the right, by winding number");
    visit("centroid", r.centroid, "centre of gravity of the arc");
    visit("bending_energy", r.bending_energy, "integral of the squared curvature");
    visit("bending_energy_error", r.bending_energy_error, "bound on its error");
    visit("energy_length", r.energy_length, "bending energy times length, free of scale");
    visit("pseudo_energy", r.pseudo_energy, "sum of energy times squared length over the pieces");
    visit("max_curvature", r.max_curvature, "the largest curvature and where it is");
    visit("turning", r.turning, "integral of the signed curvature, corners included, in radians");
    visit("inflections", r.inflections, "parameters where the curvature changes its sign");
    visit("joints", r.joints, "the continuity present at each joint");
    visit("notes", r.notes, "why numbers are missing");
}

/// All numbers of a curve at once; see the functions of the same names.
///
/// Status: `not_met` where length_error > tolerance + 2^-48 length, which rounding explains, else
/// `met`.
/// Throws: `option.range` unless the tolerance is above 0; `curve.not-finite`; `number.overflow`.
MeasureReport measure(const Curve& curve, const MeasureOptions& options = {});

}  // namespace batten
