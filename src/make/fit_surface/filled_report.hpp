#pragma once

#include <optional>
#include <vector>

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
};

/// Knots, breaks, numbers of strips and coefficients.
void fill_lines(FitSurfaceReport& report, const SplineSurface& surface);

/// Everything that follows from the residuals; after fill_lines.
void fill_criteria(FitSurfaceReport& report, const Misfit& misfit, const SampleFacts& facts);

/// Throws `number.overflow` unless all is finite.
void require_finite_solution(const std::vector<double>& coefficients, double delta2);

}  // namespace batten::surface_fitting
