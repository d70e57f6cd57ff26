#include "make/fit/pruned_choice.hpp"

#include <string>

#include "batten/base/text.hpp"
#include "make/fit/broken_fit.hpp"
#include "make/fit/free_fit.hpp"
#include "make/fit/pruning.hpp"
#include "make/fit/shape_limits.hpp"

namespace batten::fitting {
namespace {

constexpr int most_sweeps = 100;
constexpr std::size_t other_starts[] = {1, 4, 8, 16};  // equal intervals

/// Splines of several sides, or closed ones, with knots alone.
class SmoothFit final : public SiteFit {
public:
    SmoothFit(const Samples& samples, const LocalBasis& basis, Ends ends)
        : fit_(samples, basis, ends) {}

    Interval domain() const override { return fit_.domain(); }
    int order() const override { return fit_.order(); }
    int most_times() const override { return fit_.most_times(); }
    int parameters(const BrokenSites& sites) const override {
        return fit_.parameters_of(knots_of(sites));
    }
    double value(const BrokenSites& sites) override { return fit_.value(knots_of(sites)); }
    std::vector<double> full_knots(const BrokenSites& sites) const {
        return fit_.knots_of(knots_of(sites));
    }

private:
    static KnotSet knots_of(const BrokenSites& sites) {
        KnotSet set;
        for (const BrokenSite& site : sites) {
            set.at.push_back(site.at);
            set.times.push_back(site.times);
        }
        return set;
    }

    FreeFit fit_;
};

/// A knot at each of the breaks but the ends.
BrokenSites knots_at(std::span<const double> breaks) {
    BrokenSites sites;
    for (std::size_t i = 1; i + 1 < breaks.size(); ++i) sites.push_back({breaks[i], 1, false, false});
    return sites;
}

/// Sweeps until nothing is gained; whether that was soon.
bool settle(Pruning& pruning) {
    int sweeps = 0;
    while (sweeps < most_sweeps && pruning.sweep()) ++sweeps;
    return sweeps < most_sweeps;
}

/// The best of several starts, with breaks. `breaks`: of the inserted knots, whose intervals are
/// short where there may be one.
bool improve_with_breaks(Pruning& best, BrokenFit& fit, const Samples& samples,
                         std::span<const double> breaks) {
    std::vector<double> places;
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        places.push_back(knot_between({breaks[i - 1], breaks[i]}));
        places.push_back(breaks[i]);
    }
    for (const std::size_t intervals : other_starts) {
        Pruning other(fit, samples, knots_at(equal_breaks(samples.range, intervals)));
        if (!other.grow(places, best)) continue;
        settle(other);
        if (other.cost() < best.cost()) best = std::move(other);
    }
    for (int round = 0; round < most_sweeps; ++round) {
        if (!settle(best)) return false;
        if (!best.put_in_breaks(places)) return true;
    }
    return false;
}

/// Of one function y(x).
void prune_with_breaks(KnotChoice& choice, const Samples& samples, const LocalBasis& basis,
                       const FitOptions& options) {
    const int order = basis.order();
    const std::span<const double> breaks = std::span(choice.knots)
        .subspan(static_cast<std::size_t>(order - 1),
                 choice.knots.size() - 2 * static_cast<std::size_t>(order - 1));
    BrokenFit fit(samples, basis);
    Pruning pruning(fit, samples, knots_at(breaks));
    choice.is_converged = settle(pruning);
    // Limits are kept by all coefficients over stacked knots.
    if (!has_limits(options)) {
        choice.is_converged = improve_with_breaks(pruning, fit, samples, breaks);
    }
    StackedKnots knots = stacked(pruning.sites(), samples.range, order);
    choice.knots = std::move(knots.knots);
    choice.held = std::move(knots.held);
    choice.moved = knots_in(pruning.sites()) + alone_in(pruning.sites());
    note_breaks(choice, pruning.sites(), order);
}

}  // namespace

KnotChoice pruned_knots(const Samples& samples, const LocalBasis& basis,
                        const FitOptions& options) {
    FitOptions insertion = options;
    insertion.knots = KnotPlacement::automatic;
    insertion.robust = Robust::none;
    KnotChoice choice = choose_knots(samples, basis, insertion);
    choice.alternatives.clear();
    choice.notes.clear();
    if (samples.sides.size() == 1 && !options.closed) {
        prune_with_breaks(choice, samples, basis, options);
        return choice;
    }
    SmoothFit fit(samples, basis, ends_of(options));
    Pruning pruning(fit, samples, sites_of(choice.knots, samples.range));
    choice.is_converged = settle(pruning);
    choice.knots = fit.full_knots(pruning.sites());
    choice.moved = knots_in(pruning.sites());
    if (samples.sides.size() == 1) note_breaks(choice, pruning.sites(), basis.order());
    return choice;
}

void note_breaks(KnotChoice& choice, const BrokenSites& sites, int order) {
    for (const BrokenSite& site : sites) {
        const std::string place = format_number(site.at);
        if (site.jump) choice.notes.push_back("knots: a jump at " + place);
        if (site.corner) choice.notes.push_back("knots: a corner at " + place);
        if (site.alone() > 0 || site.times < order - 1 || site.times < 2) continue;
        const char* const what = site.times == order ? "knots: a jump at " : "knots: a corner at ";
        choice.notes.push_back(what + place + ", where " + std::to_string(site.times) + " stand");
    }
}

BrokenSites sites_of(std::span<const double> knots, Interval range) {
    const KnotSet set = KnotSet::of(knots, range);
    BrokenSites sites;
    for (std::size_t i = 0; i < set.size(); ++i) {
        sites.push_back({set.at[i], set.times[i], false, false});
    }
    return sites;
}

}  // namespace batten::fitting
