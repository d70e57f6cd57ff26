#pragma once

namespace batten {

/// A number and a bound on its error, both in the same unit: |value - true value| <= error.
struct Measured {
    double value = 0;
    double error = 0;
    bool operator==(const Measured&) const = default;
};

}  // namespace batten
