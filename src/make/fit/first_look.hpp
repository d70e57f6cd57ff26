#pragma once

#include <limits>

#include "make/fit/samples.hpp"

namespace batten::fitting {

/// Errors of single samples: of none as yet.
struct SigmaRange {
    double least = std::numeric_limits<double>::infinity();
    double largest = 0;
    bool are_usable = true;  ///< above 0 and finite, all of them
};

/// What reading samples in order tells.
struct FirstLook {
    std::size_t rows = 0;          ///< read so far
    bool falls = false;            ///< x, somewhere, or a NaN among x
    double largest = 0;            ///< |y|; infinite where one is NaN or Inf
    SigmaRange sigma;

    /// Nothing that samples must not have, and nothing that has no weight.
    bool is_clean(const Samples& samples) const;
};

/// Adds a run of rows, which is to begin where the last one ended (else x is taken to fall). At the
/// speed of reading.
void look_at(const Samples& samples, Rows rows, FirstLook& look);

/// Whether require_units would throw nothing.
bool has_usable_units(const Samples& samples, const FirstLook& look, int degree);

}  // namespace batten::fitting
