#pragma once

#include "make/fair/track.hpp"

namespace batten::fairing {

/// The standard deviation of the noise across the track: six points at a time, what a cubic over
/// their chord leaves, by the median of its squares [Rice1984]. Uneven spacing does no harm.
double noise_of(const Track& track);

/// Per coordinate min sum |X - D|^2 + mu sum |D4 X|^2, D4 the fourth differences by index, the
/// first `held_ends` points at each end staying.
Track smoothed(const Track& data, double mu, std::size_t held_ends);

/// The mu of least generalised cross-validation error [CravenWahba1979], the trace by the
/// eigenvalues (pi j / n)^8 of fourth differences with free ends.
double cross_validated(const Track& data, std::size_t held_ends);

}  // namespace batten::fairing
