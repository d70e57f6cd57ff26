#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace batten::arc {

/// The interval between two of the rising `joints` that holds x; of two that meet there the second.
inline std::size_t interval_of(std::span<const double> joints, double x) {
    const auto first_end = joints.begin() + 1, inner_end = joints.end() - 1;
    return static_cast<std::size_t>(std::upper_bound(first_end, inner_end, x) - first_end);
}

/// visit(interval, first, count) for each run of x that lies in one interval. Rising x cost
/// O(intervals + x), others a search each.
template <class Visit>
void for_runs(std::span<const double> joints, std::span<const double> x, const Visit& visit) {
    constexpr std::size_t near = 8;  // intervals that are looked at one by one
    std::size_t at = 0, first = 0;
    while (first < x.size()) {
        const bool is_near = at + near + 1 < joints.size() && x[first] >= joints[at] &&
                             x[first] < joints[at + near];
        if (is_near) {
            while (x[first] >= joints[at + 1]) ++at;
        } else {
            at = interval_of(joints, x[first]);
        }
        std::size_t last = first + 1;
        while (last < x.size() && x[last] >= joints[at] && x[last] < joints[at + 1]) ++last;
        visit(at, first, last - first);
        first = last;
    }
}

}  // namespace batten::arc
