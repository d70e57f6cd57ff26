#include "api/uncertain_extrema.hpp"

#include <cmath>

namespace batten::api {
namespace {

std::optional<double> where_finite(std::optional<double> deviation) {
    return deviation && std::isfinite(*deviation) ? deviation : std::nullopt;
}

}  // namespace

std::vector<UncertainExtremum> uncertain_extrema(const Curve& curve,
                                                 const FitCovariance* covariance) {
    std::vector<UncertainExtremum> all;
    for (const Extremum& e : extrema(curve, curve.dim() - 1)) {
        UncertainExtremum& next = all.emplace_back();
        next.t = e.t;
        next.value = e.value;
        next.kind = e.kind;
        if (!covariance) continue;
        next.deviation = where_finite(covariance->deviation_of_place(e.t, 1));
        next.value_deviation = where_finite(covariance->deviation(e.t));
    }
    return all;
}

}  // namespace batten::api
