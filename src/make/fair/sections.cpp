#include "make/fair/sections.hpp"

#include <algorithm>
#include <cmath>

namespace batten::fairing {
namespace {

constexpr double least_bump = 0.02;  ///< of the curvature's range

/// Indices of the extrema of `value` whose rise and fall both exceed `bump`.
std::vector<std::size_t> extrema(const std::vector<double>& value, std::size_t first,
                                 std::size_t last, double bump) {
    std::vector<std::size_t> found;
    std::size_t low = first, high = first;
    int direction = 0;
    for (std::size_t i = first; i < last; ++i) {
        if (value[i] < value[low]) low = i;
        if (value[i] > value[high]) high = i;
        if (direction >= 0 && value[high] - value[i] > bump) {
            if (direction > 0) found.push_back(high);
            direction = -1;
            low = i;
        } else if (direction <= 0 && value[i] - value[low] > bump) {
            if (direction < 0) found.push_back(low);
            direction = 1;
            high = i;
        }
    }
    return found;
}

}  // namespace

std::vector<std::size_t> section_ends(const Track& track) {
    const std::vector<double> kappa = curvatures(track);
    const std::size_t n = track.size(), first = track.closed ? 0 : 1,
                      last = track.closed ? n : n - 1;
    const auto [least, most] = std::minmax_element(kappa.begin() + static_cast<std::ptrdiff_t>(first),
                                                   kappa.begin() + static_cast<std::ptrdiff_t>(last));
    const double bump = least_bump * (*most - *least);
    std::vector<std::size_t> ends = extrema(kappa, first, last, bump);
    const double size = std::fmax(std::fabs(*least), std::fabs(*most));
    for (std::size_t i = first; i + 1 < last; ++i) {
        const bool crosses = (kappa[i] < 0) != (kappa[i + 1] < 0);
        if (crosses && std::fabs(kappa[i]) + std::fabs(kappa[i + 1]) > 1e-9 * size) {
            ends.push_back(std::fabs(kappa[i]) < std::fabs(kappa[i + 1]) ? i : i + 1);
        }
    }
    if (!track.closed) ends.insert(ends.end(), {0, n - 1});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
}

Track part_of(const Track& track, std::size_t from, std::size_t to) {
    Track part;
    for (std::size_t i = from;; i = track.next(i)) {
        part.x.push_back(track.x[i]);
        part.y.push_back(track.y[i]);
        if (i == to) break;
    }
    return part;
}

}  // namespace batten::fairing
