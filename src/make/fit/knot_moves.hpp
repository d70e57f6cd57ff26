#pragma once

#include <span>

#include "make/fit/free_fit.hpp"

/// Steps that keep knots in order, and knots that meet or part.
namespace batten::fitting {

double gap_before(const FreeFit& fit, const KnotSet& set, std::size_t j);
double gap_after(const FreeFit& fit, const KnotSet& set, std::size_t j);

/// Whether all gaps are above 1e-9 of the domain.
bool is_ordered(const FreeFit& fit, const KnotSet& set);

/// The largest share of `step` that keeps a tenth of every gap.
double step_share(const FreeFit& fit, const KnotSet& set, std::span<const double> step);

KnotSet moved(const KnotSet& set, std::span<const double> step, double share);

/// Places j and j + 1 made one, between them by their multiplicities.
KnotSet joined(const KnotSet& set, std::size_t j);

/// Place j made two, `distance` apart.
KnotSet split_at(const KnotSet& set, std::size_t j, double distance);

}  // namespace batten::fitting
