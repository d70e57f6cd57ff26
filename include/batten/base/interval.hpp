#pragma once

#include <algorithm>

namespace batten {

/// A closed interval [lo, hi].
struct Interval {
    double lo = 0;
    double hi = 0;

    double length() const { return hi - lo; }
    double middle() const { return lo + 0.5 * (hi - lo); }
    bool contains(double x) const { return lo <= x && x <= hi; }
    double clamp(double x) const { return std::clamp(x, lo, hi); }
    bool operator==(const Interval&) const = default;
};

}  // namespace batten
