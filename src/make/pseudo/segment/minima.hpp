#pragma once

#include <vector>

#include "batten/make/pseudo_segment.hpp"

namespace batten::pseudo {

/// A local minimum of J over r0, r1.
struct Minimum {
    PseudoSegment segment;
    double energy = 0;         // E
    double length = 1;         // L
    double pseudo_energy = 0;  // J
    bool is_converged = true;  // false: 100 Newton steps did not suffice, J may still fall
};

/// The least minimum; see `least_pseudo_segment`. Of minima equal to 1e-14 of J the one found from
/// the most central start counts, so that short arcs, where rivals cannot be told apart in double,
/// stay symmetric.
Minimum least_minimum(double theta0, double theta1);

/// The minima reached from the few starts that suffice for the least one, which is the first.
std::vector<Minimum> central_minima(double theta0, double theta1);

/// All minima found; see `pseudo_minima`.
std::vector<Minimum> all_minima(double theta0, double theta1);

/// The minimum whose valley `start` lies in: what follows one branch while its angles move.
Minimum minimum_near(const PseudoSegment& start);

}  // namespace batten::pseudo
