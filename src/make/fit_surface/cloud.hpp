#pragma once

#include <array>
#include <optional>
#include <vector>

#include "batten/make/fit_scattered.hpp"
#include "make/fit_surface/solve.hpp"

namespace batten::surface_fitting {

/// Scattered heights and their weights, 1 / sigma.
struct Cloud {
    std::span<const double> x, y, z;
    std::vector<double> weight;
    Rectangle domain;
    bool sigma_known = false;
    SigmaSource source = SigmaSource::estimated;
    std::optional<double> sigma = {};
    double least_delta2 = 0;  ///< what rounding leaves, where errors are not known

    std::size_t count() const { return x.size(); }
};

/// Checks what `fit_scattered` promises to check about the samples.
Cloud prepared_cloud(const ScatteredSamples& samples, const FitSurfaceOptions& options);

struct CloudFit {
    Solution solution;
    Misfit misfit;
    std::vector<std::array<int, 2>> open;  ///< coefficients without a sample in their support
    std::size_t faint = 0;                 ///< others that only smoothness determines
};

/// The best coefficients for these knots. Source: [GolubVanLoan2013, 4.2], sparse.
CloudFit fit_cloud(const Cloud& cloud, const BSplineBasis& x, const BSplineBasis& y,
                   StripRule rule);

}  // namespace batten::surface_fitting
