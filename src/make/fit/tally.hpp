#pragma once

#include <cstddef>
#include <span>

#include "batten/make/fit_statistics.hpp"
#include "batten/shape/spline_function.hpp"
#include "make/fit/samples.hpp"

namespace batten::fitting {

/// What the residuals e = y - S(x) of a fit say.
struct ResidualTally {
    double delta2 = 0;
    Psi psi{};
    double max_residual = 0;            ///< data units
    std::size_t runs = 0, positive = 0; ///< of equal signs, in rising x; zero counts as positive
};

/// Of residuals that are there already, one a sample, data units.
ResidualTally tally(const Samples& samples, std::span<const double> residuals);

/// Of a spline, in one pass over the samples without memory of its own.
ResidualTally tally(const Samples& samples, const SplineFunction& spline, int side = 0);

}  // namespace batten::fitting
