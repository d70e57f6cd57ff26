#pragma once

namespace batten {

/// An accuracy that is asked for: in data units, or as a share of the input's extent.
struct Tolerance {
    double value = 0;
    bool is_relative = false;

    /// The tolerance in data units, for input of the given extent.
    double in_units(double extent) const { return is_relative ? value * extent : value; }
    bool operator==(const Tolerance&) const = default;
};

constexpr Tolerance absolute(double value) { return {value, false}; }
constexpr Tolerance relative(double value) { return {value, true}; }

}  // namespace batten
