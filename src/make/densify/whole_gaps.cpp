#include "make/densify/whole_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace batten::lagrange {
namespace {

/// Gaps between the places that divide the density's sum into equal parts.
std::vector<double> exact_gaps(const std::vector<double>& density, std::size_t gaps) {
    std::vector<double> sums(1, 0.0);
    for (const double share : density) sums.push_back(sums.back() + share);
    std::vector<double> result;
    double before = 0;
    for (std::size_t i = 1, cell = 0; i <= gaps; ++i) {
        const double target = sums.back() * static_cast<double>(i) / static_cast<double>(gaps);
        while (cell + 2 < sums.size() && sums[cell + 1] <= target) ++cell;
        const double inside = (target - sums[cell]) / (sums[cell + 1] - sums[cell]);
        const double place = static_cast<double>(cell) + inside;
        result.push_back(place - before);
        before = place;
    }
    return result;
}

std::vector<std::size_t> rounded(const std::vector<double>& gaps, double scale) {
    std::vector<std::size_t> result;
    for (const double gap : gaps) {
        result.push_back(static_cast<std::size_t>(std::max(1.0, std::round(scale * gap))));
    }
    return result;
}

std::size_t total(const std::vector<std::size_t>& gaps) {
    return std::accumulate(gaps.begin(), gaps.end(), std::size_t{0});
}

}  // namespace

std::vector<std::size_t> whole_gaps(const std::vector<double>& density, std::size_t gaps) {
    const std::vector<double> wanted = exact_gaps(density, gaps);
    double lo = 0, hi = 4;  // all gaps are 1 for the one; their sum is too large for the other
    for (int halving = 0; halving < 60; ++halving) {
        const double scale = 0.5 * (lo + hi);
        (total(rounded(wanted, scale)) <= density.size() ? lo : hi) = scale;
    }
    std::vector<std::size_t> result = rounded(wanted, lo);
    const std::vector<std::size_t> longer = rounded(wanted, hi);
    std::size_t missing = density.size() - total(result);
    for (std::size_t i = 0; i < gaps && missing > 0; ++i) {
        if (longer[i] <= result[i]) continue;
        ++result[i];
        --missing;
    }
    return result;
}

}  // namespace batten::lagrange
