#include "make/fit/exchange.hpp"

#include <algorithm>
#include <cmath>

namespace batten::fitting {
namespace {

constexpr double shares[] = {0.25, 0.5, 0.75};
constexpr int refined_best = 6;         // with 6 all starts of the tests find the best
constexpr double enough_gain = 1e-7;    // relative, to go on
constexpr Effort quick{6, 4};           // enough to rank
constexpr int polishing_steps = 60;

KnotSet inserted(const KnotSet& set, std::size_t gap, double at) {
    KnotSet result = set;
    result.at.insert(result.at.begin() + static_cast<std::ptrdiff_t>(gap), at);
    result.times.insert(result.times.begin() + static_cast<std::ptrdiff_t>(gap), 1);
    return result;
}

KnotSet without(const KnotSet& set, std::size_t j) {
    KnotSet result = set;
    if (--result.times[j] > 0) return result;
    result.at.erase(result.at.begin() + static_cast<std::ptrdiff_t>(j));
    result.times.erase(result.times.begin() + static_cast<std::ptrdiff_t>(j));
    return result;
}

struct Ranked {
    KnotSet set;
    double delta2;
};

/// All sets with one knot more, the best first.
std::vector<Ranked> candidates(FreeFit& fit, const KnotSet& set) {
    std::vector<Ranked> result;
    for (std::size_t gap = 0; gap <= set.size(); ++gap) {
        const double lo = gap == 0 ? fit.domain().lo : set.at[gap - 1];
        const double hi = gap == set.size() ? fit.domain().hi : set.at[gap];
        for (const double share : shares) {
            const KnotSet more = inserted(set, gap, lo + share * (hi - lo));
            const double value = fit.value(more);
            if (std::isfinite(value)) result.push_back({more, value});
        }
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Ranked& a, const Ranked& b) { return a.delta2 < b.delta2; });
    return result;
}

}  // namespace

Descent with_one_more(FreeFit& fit, const KnotSet& set, int refined) {
    const std::vector<Ranked> ranked = candidates(fit, set);
    Descent best{set, fit.value(set), 0, false};
    bool is_first = true;
    const std::size_t count = std::min(ranked.size(), static_cast<std::size_t>(refined));
    for (std::size_t i = 0; i < count; ++i) {
        Descent tried = descend(fit, ranked[i].set, quick);
        if (is_first || tried.delta2 < best.delta2) best = std::move(tried);
        is_first = false;
    }
    return best;
}

Descent exchange(FreeFit& fit, Descent start) {
    Descent best = std::move(start);
    for (bool gains = true; gains;) {
        gains = false;
        Descent candidate = best;
        for (std::size_t j = 0; j < best.set.size(); ++j) {
            const Descent tried = with_one_more(fit, without(best.set, j), refined_best);
            const bool is_whole = tried.set.count() == best.set.count();
            if (is_whole && tried.delta2 < candidate.delta2) candidate = tried;
        }
        const Descent polished = newton_descent(fit, candidate.set, polishing_steps);
        if (polished.delta2 < best.delta2 * (1 - enough_gain)) {
            best = polished;
            gains = true;
        }
    }
    return best;
}

}  // namespace batten::fitting
