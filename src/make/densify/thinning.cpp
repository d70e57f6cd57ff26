#include "make/densify/thinning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "make/densify/whole_gaps.hpp"

namespace batten::lagrange {
namespace {

DensifyOptions options_of(const ThinOptions& options) {
    DensifyOptions result;
    result.degree = options.degree;
    result.end_degree = options.end_degree;
    result.parameter = options.parameter;
    result.closed = options.closed;
    return result;
}

Points ring(PointsView points, bool closed) {
    const std::size_t n = points.size();
    if (!closed || n < 2) return Points(points);
    const bool repeated = std::equal(points[0].begin(), points[0].end(), points[n - 1].begin());
    return Points(repeated ? points.part(0, n - 1) : points);
}

constexpr double out_of_reach = std::numeric_limits<double>::infinity();

}  // namespace

Thinning::Thinning(PointsView points, const ThinOptions& options)
    : options_(options_of(options)),
      points_(ring(points, options.closed)),
      curve_(CellMaker(points_, options_), options.closed),
      tolerance_(options.tolerance.in_units(extent(points_))) {}

std::size_t Thinning::fewest() const {
    const int highest = std::max(options_.degree, options_.end_degree.value_or(options_.degree));
    return static_cast<std::size_t>(options_.closed ? std::max(options_.degree + 1, 3)
                                                    : highest + 1);
}

Thinning::Choice Thinning::all() const {
    Choice choice(points_.size());
    std::iota(choice.begin(), choice.end(), std::size_t{0});
    return choice;
}

std::ptrdiff_t Thinning::reach() const {
    return std::max(options_.degree, options_.end_degree.value_or(options_.degree)) + 1;
}

Points Thinning::rows(const Choice& choice) const {
    Points result(0, points_.dim());
    for (const std::size_t i : choice) result.push_back(points_[i % points_.size()]);
    return result;
}

std::vector<double> Thinning::errors(const Choice& choice, double enough, Care care) const {
    const Points kept = rows(choice);
    const CellCurve curve(CellMaker(kept, options_), options_.closed);
    std::vector<double> result;
    for (std::size_t cell = 0; cell < curve.cells(); ++cell) {
        result.push_back(largest_gap(curve_, match(curve, cell, choice), care, enough));
    }
    return result;
}

Match Thinning::match(const CellCurve& kept, std::size_t cell, const Choice& choice) const {
    const bool wraps = cell + 1 == choice.size();
    return {kept, cell, choice[cell], wraps ? points_.size() + choice[0] : choice[cell + 1]};
}

double Thinning::error(const Choice& choice) const {
    const std::vector<double> each = errors(choice, out_of_reach, Care::full);
    return *std::max_element(each.begin(), each.end());
}

bool Thinning::meets(const Choice& choice, Care care) const {
    const Points kept = rows(choice);
    const CellCurve curve(CellMaker(kept, options_), options_.closed);
    for (std::size_t cell = 0; cell < curve.cells(); ++cell) {
        const double gap = largest_gap(curve_, match(curve, cell, choice), care, tolerance_);
        if (gap > tolerance_) return false;
    }
    return true;
}

/// Whether the cells that see the places [lo, hi] of a choice meet the tolerance. They lie within
/// `reach` of them, and see as far again.
bool Thinning::meets_between(const Choice& choice, std::ptrdiff_t lo, std::ptrdiff_t hi,
                             Care care) const {
    const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(choice.size());
    const bool cut_start = options_.closed || lo - 2 * reach() > 0;
    const bool cut_end = options_.closed || hi + 2 * reach() < n - 1;
    if (hi - lo + 4 * reach() >= n || (cut_start != cut_end && options_.end_degree)) {
        return meets(choice, care);
    }
    const std::ptrdiff_t first = cut_start ? lo - 2 * reach() : 0;
    const std::ptrdiff_t last = cut_end ? hi + 2 * reach() : n - 1;
    Choice near;  // on a ring counted on round by round, from the round before on
    for (std::ptrdiff_t i = first; i <= last; ++i) {
        const std::ptrdiff_t place = (i % n + n) % n, turns = (i - place) / n + 1;
        const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(
            choice[static_cast<std::size_t>(place)]);
        near.push_back(static_cast<std::size_t>(
            row + (options_.closed ? turns : 0) * static_cast<std::ptrdiff_t>(points_.size())));
    }
    DensifyOptions open = options_;
    open.closed = false;
    const Points kept = rows(near);
    const CellCurve curve(CellMaker(kept, open), false);
    const std::ptrdiff_t from = std::max(first, lo - reach()), to = std::min(last, hi + reach());
    for (std::ptrdiff_t i = from; i < to; ++i) {
        const std::size_t cell = static_cast<std::size_t>(i - first);
        const Match match{curve, cell, near[cell], near[cell + 1]};
        if (largest_gap(curve_, match, care, tolerance_) > tolerance_) return false;
    }
    return true;
}

Thinning::Choice Thinning::without(const Choice& choice, std::size_t place,
                                   std::size_t spread) const {
    Choice round = choice;
    if (options_.closed) round.push_back(points_.size());
    const std::size_t lo = place - std::min(place, spread + 1);
    const std::size_t hi = std::min(place + spread + 1, round.size() - 1);
    Choice result(round.begin(), round.begin() + static_cast<std::ptrdiff_t>(lo) + 1);
    const double old_gaps = static_cast<double>(hi - lo);
    for (std::size_t i = 1; i + 1 < hi - lo; ++i) {
        const double rank = static_cast<double>(i) * old_gaps / (old_gaps - 1);
        const std::size_t whole = static_cast<std::size_t>(rank);
        const double here = static_cast<double>(round[lo + whole]);
        const double next = static_cast<double>(round[lo + whole + 1]);
        const double row = here + (rank - static_cast<double>(whole)) * (next - here);
        result.push_back(static_cast<std::size_t>(std::lround(row)));
    }
    result.insert(result.end(), round.begin() + static_cast<std::ptrdiff_t>(hi), round.end());
    if (options_.closed) result.pop_back();
    return result;
}

Thinning::Choice Thinning::reduced(Choice choice, Care care) const {
    constexpr std::array<std::size_t, 5> spreads{0, 1, 2, 4, 8};
    const auto try_without = [&](std::size_t place) {
        for (const std::size_t spread : spreads) {
            Choice fewer = without(choice, place, spread);
            const bool rises = std::adjacent_find(fewer.begin(), fewer.end(),
                                                  std::greater_equal<>()) == fewer.end();
            const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(place);
            const std::ptrdiff_t half = static_cast<std::ptrdiff_t>(spread) + 1;
            if (!rises || !meets_between(fewer, at - half, at + half, care)) continue;
            choice = std::move(fewer);
            return;
        }
    };
    // A round that takes out less than one in 64 is the last.
    for (std::size_t before = 2 * choice.size(); before - choice.size() > before / 64;) {
        before = choice.size();
        const std::vector<double> each = errors(choice, tolerance_, care);
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 1; i < choice.size() - (options_.closed ? 0 : 1); ++i) {
            order.emplace_back(std::max(each[i - 1], each[i]), choice[i]);
        }
        std::sort(order.begin(), order.end());
        for (const auto& [error, row] : order) {
            if (choice.size() <= fewest()) break;
            const auto at = std::lower_bound(choice.begin(), choice.end(), row);
            if (at == choice.end() || *at != row) continue;
            try_without(static_cast<std::size_t>(at - choice.begin()));
        }
    }
    return choice;
}

Thinning::Choice Thinning::strided(Care care) const {
    const std::vector<double> level(curve_.cells(), 1.0);
    std::size_t next = fewest();
    for (std::size_t count = next; count < points_.size(); ++count) {
        const std::size_t gaps = options_.closed ? count : count - 1;
        if (count < next && curve_.cells() % gaps != 0) continue;
        Choice choice = spaced(level, count);
        if (meets(choice, care)) return choice;
        if (count >= next) next = count + 1 + count / 32;
    }
    return all();
}

Thinning::Choice Thinning::spaced(const std::vector<double>& density, std::size_t count) const {
    Choice choice{0};
    for (const std::size_t gap : whole_gaps(density, options_.closed ? count : count - 1)) {
        choice.push_back(choice.back() + gap);
    }
    if (options_.closed) choice.pop_back();
    return choice;
}

std::vector<double> Thinning::evened(const std::vector<double>& density, const Choice& choice,
                                     const std::vector<double>& errors) const {
    // A cell's error goes with its length to the power degree + 1.
    const double power = 1 / static_cast<double>(options_.degree + 1);
    std::vector<double> factor(density.size(), 1.0);
    for (std::size_t cell = 0; cell < errors.size(); ++cell) {
        const double share = errors[cell] / tolerance_;
        const double change = std::clamp(std::pow(share, power), 0.5, 2.0);
        const std::size_t last = cell + 1 < choice.size() ? choice[cell + 1] : points_.size();
        for (std::size_t k = choice[cell]; k < last && k < factor.size(); ++k) factor[k] = change;
    }
    std::vector<double> result(density.size());
    const std::size_t n = density.size();
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t before = k > 0 ? k - 1 : (options_.closed ? n - 1 : 0);
        const std::size_t after = k + 1 < n ? k + 1 : (options_.closed ? 0 : n - 1);
        result[k] = density[k] * (0.25 * factor[before] + 0.5 * factor[k] + 0.25 * factor[after]);
    }
    return result;
}

Thinning::Choice Thinning::met_with(std::size_t count, Care care) const {
    constexpr int rounds = 6;
    std::vector<double> density(curve_.cells(), 1.0);
    for (int round = 0; round < rounds; ++round) {
        Choice choice = spaced(density, count);
        const std::vector<double> each = errors(choice, 16 * tolerance_, care);
        if (*std::max_element(each.begin(), each.end()) <= tolerance_) return choice;
        density = evened(density, choice, each);
    }
    return {};
}

Thinning::Choice Thinning::evenly(Care care) const {
    Choice best = all();
    std::size_t misses = fewest() - 1, meets = points_.size();
    while (meets - misses > 1 + misses / 64) {
        const std::size_t count = misses + (meets - misses) / 2;
        Choice choice = met_with(count, care);
        if (choice.empty()) {
            misses = count;
        } else {
            meets = count;
            best = std::move(choice);
        }
    }
    return best;
}

Thinning::Choice Thinning::found(Care care) const {
    Choice first = evenly(care), second = strided(care);
    if (second.size() < first.size()) std::swap(first, second);
    const std::size_t hopeless = first.size() + first.size() / 2;
    first = reduced(std::move(first), care);
    if (second.size() > hopeless) return first;
    second = reduced(std::move(second), care);
    return second.size() < first.size() ? second : first;
}

std::vector<double> Thinning::own_errors() const {
    constexpr int places = 4;
    DensifyOptions higher = options_;
    higher.degree = options_.degree + 1;
    higher.end_degree = options_.end_degree.value_or(options_.degree) + 1;
    const bool possible = higher.degree <= highest_degree && *higher.end_degree <= highest_degree &&
                          points_.size() > fewest();
    std::vector<double> result(curve_.cells(), 0.0);
    if (!possible) return result;
    const CellCurve other(CellMaker(points_, higher), options_.closed);
    std::vector<double> p(static_cast<std::size_t>(points_.dim()));
    for (std::size_t cell = 0; cell < result.size(); ++cell) {
        for (int i = 1; i < places; ++i) {
            const double s = static_cast<double>(i) / places;
            other.point(cell, s, p);
            result[cell] = std::max(result[cell], foot_on(curve_, cell, p, s).distance);
        }
    }
    return result;
}

}  // namespace batten::lagrange
