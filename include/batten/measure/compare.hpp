#pragma once

#include <concepts>
#include <optional>
#include <type_traits>
#include <variant>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/measure/deviation.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

struct CompareOptions {
    std::variant<Points, Curve> to;
    std::optional<Tolerance> tolerance;
    Tolerance accuracy = relative(1e-6);
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, CompareOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("to", o.to, anything, "points or a curve to compare with");
    visit("tolerance", o.tolerance, more_than(0),
          "largest deviation allowed; 1e-3r is relative to the curve's extent");
    visit("accuracy", o.accuracy, more_than(0),
          "how exactly the Hausdorff distance, and the deviation from a curve, are found");
}

struct CompareReport {
    double max = 0;
    double rms = 0;
    double mean = 0;
    double hausdorff = 0;
    DeviationPlace at;
    std::optional<bool> within;
    Status status = Status::met;
};

template <class Report, class Visit>
    requires std::same_as<std::remove_const_t<Report>, CompareReport>
void visit_fields(Report& r, Visit&& visit) {
    visit("max", r.max, "deviation of largest magnitude; in the plane positive to the left");
    visit("rms", r.rms, "root of the mean square deviation");
    visit("mean", r.mean, "mean of the signed deviations");
    visit("hausdorff", r.hausdorff, "largest distance from any point of either to the other");
    visit("at", r.at, "where the largest deviation is");
    visit("within", r.within, "whether the largest deviation is within the tolerance");
}

/// How far points, or another curve, are from `curve`; see `deviation`.
///
/// Status: `not_met` where a tolerance is given and |max| > tolerance, else `met`. Against a curve
/// |max| is found with an accuracy of a hundredth of the tolerance, if that is asked for less.
/// Throws: as `deviation`.
CompareReport compare(const Curve& curve, const CompareOptions& options);

}  // namespace batten
