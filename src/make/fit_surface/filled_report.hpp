#pragma once

#include <optional>
#include <vector>

#include "batten/make/fit_front.hpp"
#include "batten/make/fit_surface_report.hpp"
#include "batten/shape/spline_surface.hpp"
#include "make/fit_surface/solve.hpp"

namespace batten::surface_fitting {

/// What a report says of the samples.
struct SampleFacts {
    std::size_t count = 0;
    std::size_t missing = 0;
    bool sigma_known = false;
    SigmaSource source = SigmaSource::estimated;
    std::optional<double> sigma;
    double least_delta2 = 0;  ///< what rounding leaves
};

SampleFacts facts_of(const Nodes& nodes);

/// Knots, breaks, numbers of strips and coefficients.
void fill_lines(FitSurfaceReport& report, const SplineSurface& surface);

/// Everything that follows from the residuals; after fill_lines.
void fill_criteria(SurfaceQuality& report, const Misfit& misfit, const SampleFacts& facts);

constexpr const char* note_of_holes =
    "holes in the data leave coefficients open: continued smoothly";

/// Notes where a surface goes far beyond the heights, from `heights.lo` to `heights.hi`, as it may in
/// holes at whose edges it is hardly seen.
void note_what_lies_beyond(FitSurfaceReport& report, const SplineSurface& surface,
                           Interval heights);

/// Notes where the surface swings between the samples, or leaves more than the errors.
void note_what_is_badly_fitted(FitSurfaceReport& report);

/// What a front's report says of its nodes: after delta2, parameters and bic.
void fill_front(FrontReport& report, const Nodes& nodes, const CurvedKnotSurface& surface);

/// Throws `fit.too-few` for fewer nodes than coefficients.
void require_enough_nodes(std::size_t nodes, std::size_t coefficients);

/// Throws `number.overflow` unless all is finite.
void require_finite_solution(const std::vector<double>& coefficients, double delta2);

}  // namespace batten::surface_fitting
