#include "make/fit/knot_moves.hpp"

#include <algorithm>

namespace batten::fitting {
namespace {

constexpr double least_gap = 1e-9;  // of the domain: nearer knots are refused
constexpr double gap_kept = 0.1;    // a step leaves at least this share of every gap

}  // namespace

double gap_before(const FreeFit& fit, const KnotSet& set, std::size_t j) {
    return set.at[j] - (j == 0 ? fit.domain().lo : set.at[j - 1]);
}

double gap_after(const FreeFit& fit, const KnotSet& set, std::size_t j) {
    return (j + 1 == set.size() ? fit.domain().hi : set.at[j + 1]) - set.at[j];
}

bool is_ordered(const FreeFit& fit, const KnotSet& set) {
    const double least = least_gap * fit.domain().length();
    for (std::size_t j = 0; j < set.size(); ++j) {
        if (!(gap_before(fit, set, j) > least)) return false;
    }
    return set.size() == 0 || gap_after(fit, set, set.size() - 1) > least;
}

double step_share(const FreeFit& fit, const KnotSet& set, std::span<const double> step) {
    double share = 1;
    for (std::size_t j = 0; j <= set.size(); ++j) {
        const bool is_end = j == set.size();
        const double gap = is_end ? gap_after(fit, set, j - 1) : gap_before(fit, set, j);
        const double change = (is_end ? 0 : step[j]) - (j == 0 ? 0 : step[j - 1]);
        if (gap + change < gap_kept * gap) share = std::min(share, (gap_kept - 1) * gap / change);
    }
    return share;
}

KnotSet moved(const KnotSet& set, std::span<const double> step, double share) {
    KnotSet result = set;
    for (std::size_t j = 0; j < set.size(); ++j) result.at[j] += share * step[j];
    return result;
}

KnotSet joined(const KnotSet& set, std::size_t j) {
    KnotSet result = set;
    const double share = static_cast<double>(set.times[j + 1]) / (set.times[j] + set.times[j + 1]);
    result.at[j] += share * (set.at[j + 1] - set.at[j]);
    result.times[j] += set.times[j + 1];
    result.at.erase(result.at.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    result.times.erase(result.times.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    return result;
}

KnotSet split_at(const KnotSet& set, std::size_t j, double distance) {
    KnotSet result = set;
    result.at[j] = set.at[j] - 0.5 * distance;
    result.times[j] = set.times[j] / 2;
    result.at.insert(result.at.begin() + static_cast<std::ptrdiff_t>(j) + 1,
                     set.at[j] + 0.5 * distance);
    result.times.insert(result.times.begin() + static_cast<std::ptrdiff_t>(j) + 1,
                        set.times[j] - set.times[j] / 2);
    return result;
}

}  // namespace batten::fitting
