#pragma once

#include <optional>
#include <vector>

#include "batten/make/fit_bands.hpp"
#include "batten/measure/coordinate.hpp"

namespace batten::api {

/// An extremum, and how sure its place and its height are, where that is known.
struct UncertainExtremum {
    double t = 0;
    std::optional<double> deviation;
    double value = 0;
    std::optional<double> value_deviation;
    ExtremumKind kind = ExtremumKind::maximum;
};

template <class Visit>
void visit_fields(const UncertainExtremum& r, Visit&& visit) {
    visit("t", r.t, "its place");
    visit("deviation", r.deviation,
          "standard deviation of the place; none where it is flat, at a corner, and where no errors "
          "are known");
    visit("value", r.value, "its height");
    visit("value_deviation", r.value_deviation, "standard deviation of the height");
    visit("kind", r.kind, "minimum or maximum");
}

/// The extrema of the last coordinate. Without a covariance (null) nothing is known of errors.
std::vector<UncertainExtremum> uncertain_extrema(const Curve& curve,
                                                 const FitCovariance* covariance);

}  // namespace batten::api
