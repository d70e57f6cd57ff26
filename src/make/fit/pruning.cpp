#include "make/fit/pruning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "make/fit/tree.hpp"

namespace batten::fitting {
namespace {

constexpr double cost_gain_enough = 0.01;  // of a criterion in which 2 is hardly worth mentioning
/// Parameters: what a place is worth, beside a break also its coefficient.
constexpr double knot_place = 0.5, corner_charge = 2.5, jump_charge = 3;
constexpr double move_shares[] = {0.5, 0.25, 0.1, 0.03, 0.01};  // of a gap: how far a site is moved
constexpr int move_samples[] = {1, 2, 4};  // what stands alone, besides
constexpr int refine_samples[] = {16, 8, 4, 2, 1};
constexpr int most_replaced = 6;    // knots that a break may stand for
constexpr double least_site_gap = 1e-9;  // of the domain: nearer sites are refused
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr bool BrokenSite::*break_kinds[] = {&BrokenSite::jump, &BrokenSite::corner};

void erase_if_smooth(BrokenSites& sites, std::size_t j) {
    if (sites[j].times > 0 || sites[j].alone() > 0) return;
    sites.erase(sites.begin() + static_cast<std::ptrdiff_t>(j));
}

BrokenSites fewer(const BrokenSites& sites, std::size_t j) {
    BrokenSites next = sites;
    --next[j].times;
    erase_if_smooth(next, j);
    return next;
}

/// The site at `place`, made where there is none.
std::size_t site_at(BrokenSites& sites, double place) {
    std::size_t j = 0;
    while (j < sites.size() && sites[j].at < place) ++j;
    if (j == sites.size() || sites[j].at != place) {
        sites.insert(sites.begin() + static_cast<std::ptrdiff_t>(j), {place, 0, false, false});
    }
    return j;
}

/// Takes out the knot or break nearest to `place`, but no break there; whether there was one.
bool take_nearest(BrokenSites& sites, double place) {
    std::size_t nearest = sites.size();
    for (std::size_t j = 0; j < sites.size(); ++j) {
        if (sites[j].at == place && sites[j].times == 0) continue;
        const bool is_nearer = nearest == sites.size() ||
                               std::fabs(sites[j].at - place) <
                                   std::fabs(sites[nearest].at - place);
        if (is_nearer) nearest = j;
    }
    if (nearest == sites.size()) return false;
    BrokenSite& site = sites[nearest];
    if (site.times > 0) {
        --site.times;
    } else {
        (site.jump ? site.jump : site.corner) = false;
    }
    erase_if_smooth(sites, nearest);
    return true;
}

}  // namespace

Pruning::Pruning(SiteFit& fit, const Samples& samples, BrokenSites start)
    : fit_(&fit), samples_(&samples), sites_(std::move(start)), cost_(cost_of(sites_)) {}

bool Pruning::sweep() {
    const double before = cost_;
    take_out();
    move();
    stack();
    put_in();
    return cost_ < before - cost_gain_enough;
}

bool Pruning::put_in_breaks(std::span<const double> places) {
    const double before = cost_;
    for (std::size_t j = 0; j < sites_.size(); ++j) break_beside(sites_[j].at);
    while (add_best(places)) {}
    return cost_ < before - cost_gain_enough;
}

bool Pruning::grow(std::span<const double> places, const Pruning& other) {
    const double allowed = other.charge_of(other.sites_);
    double gain = infinite;
    for (;;) {
        const double charged = charge_of(sites_), before = cost_;
        const double left = std::max(allowed - charged, 0.0) / unit();
        // What it is charged may be saved by taking out again.
        const bool is_hopeless = std::isfinite(gain) &&
                                 cost_ - gain * left - charged > other.cost_;
        if (is_hopeless) return false;
        if (!add_best(places)) return true;
        gain = before - cost_;
    }
}

double Pruning::unit() const { return std::log(static_cast<double>(samples_->values())); }

double Pruning::charge_of(const BrokenSites& sites) const {
    const double knot_charge = static_cast<double>(samples_->directions()) + knot_place;
    double sum = 0;
    for (const BrokenSite& site : sites) {
        sum += knot_charge * site.times + corner_charge * site.corner + jump_charge * site.jump;
    }
    return unit() * sum;
}

double Pruning::cost_of(const BrokenSites& sites) {
    if (!is_ordered(sites)) return infinite;
    const double delta2 = fit_->value(sites), n = static_cast<double>(samples_->values());
    if (!std::isfinite(delta2)) return delta2;
    // Where delta2 enters by its logarithm, interpolation would always win.
    const int p = fit_->parameters(sites);
    if (!samples_->sigma_known && 2 * p > static_cast<int>(samples_->values())) return infinite;
    const double least = std::max(samples_->least_delta2, std::numeric_limits<double>::min());
    const double misfit = samples_->sigma_known ? delta2 : n * std::log(std::max(delta2, least));
    return misfit + charge_of(sites);
}

bool Pruning::is_ordered(const BrokenSites& sites) const {
    const double least = least_site_gap * fit_->domain().length();
    double last = fit_->domain().lo;
    for (const BrokenSite& site : sites) {
        if (!(site.at - last > least)) return false;
        last = site.at;
    }
    return sites.empty() || fit_->domain().hi - last > least;
}

bool Pruning::take(BrokenSites next) {
    const double cost = cost_of(next);
    return take_at(std::move(next), cost);
}

bool Pruning::take_at(BrokenSites next, double cost) {
    if (!(cost < cost_)) return false;
    sites_ = std::move(next);
    cost_ = cost;
    return true;
}

double Pruning::before(std::size_t j) const {
    return j == 0 ? fit_->domain().lo : sites_[j - 1].at;
}

double Pruning::after(std::size_t j) const {
    return j + 1 == sites_.size() ? fit_->domain().hi : sites_[j + 1].at;
}

void Pruning::take_out() {
    for (std::size_t j = sites_.size(); j-- > 0;) {
        while (j < sites_.size() && sites_[j].times > 0 && take(fewer(sites_, j))) {}
        for (const Kind kind : break_kinds) {
            if (j >= sites_.size() || !(sites_[j].*kind)) continue;
            BrokenSites next = sites_;
            next[j].*kind = false;
            erase_if_smooth(next, j);
            take(std::move(next));
        }
    }
}

/// Every site to where it serves better between its neighbours, long ways first.
void Pruning::move() {
    for (std::size_t j = 0; j < sites_.size(); ++j) {
        for (const double share : move_shares) {
            for (const double side : {-1.0, 1.0}) {
                const double at = sites_[j].at;
                move_to(j, at + side * share * (side < 0 ? at - before(j) : after(j) - at));
            }
        }
        if (sites_[j].alone() == 0) continue;
        for (const int step : move_samples) {
            for (const int side : {-1, 1}) move_to(j, gap_beside(sites_[j].at, side * step));
        }
    }
}

void Pruning::move_to(std::size_t j, double place) {
    BrokenSites next = sites_;
    next[j].at = place;
    take(std::move(next));
}

/// One knot of a site to its neighbour.
void Pruning::stack() {
    for (std::size_t j = 0; j < sites_.size(); ++j) {
        for (const int side : {-1, 1}) {
            const std::size_t to = j + static_cast<std::size_t>(side);
            if (to >= sites_.size() || !has_room(sites_[to]) || sites_[j].times == 0) continue;
            BrokenSites next = sites_;
            ++next[to].times;
            if (take(fewer(next, j))) break;
        }
    }
}

/// One more knot at a site, or in the middle between two.
void Pruning::put_in() {
    for (std::size_t j = 0; j < sites_.size(); ++j) {
        if (has_room(sites_[j])) take(with({sites_[j].at, nullptr}));
    }
    for (std::size_t gap = 0; gap <= sites_.size(); ++gap) {
        const bool is_last = gap == sites_.size();
        const Interval between{is_last && gap > 0 ? sites_[gap - 1].at : before(gap),
                               is_last ? fit_->domain().hi : sites_[gap].at};
        take(with({knot_between(between), nullptr}));
    }
}

/// A jump or a corner at or beside a site in place of the knots around.
void Pruning::break_beside(double place) {
    if (fit_->order() > 2) break_at(place, &BrokenSite::corner);
    for (const int step : {0, -1, 1}) {
        for (const Kind kind : kinds()) break_at(gap_beside(place, step), kind);
    }
}

void Pruning::break_at(double place, Kind kind) {
    if (!(fit_->domain().lo < place && place < fit_->domain().hi)) return;
    BrokenSites next = sites_;
    const std::size_t j = site_at(next, place);
    if (next[j].*kind) return;
    next[j].*kind = true;
    double least = infinite;
    for (int replaced = 0; replaced <= most_replaced; ++replaced) {
        const double cost = can_say(next, place) ? cost_of(next) : infinite;
        if (take_at(next, cost)) return;
        // Where the break stands for a knot, that can go at no loss.
        if (cost > least + unit() || !take_nearest(next, place)) return;
        least = std::min(least, cost);
    }
}

bool Pruning::add_best(std::span<const double> places) {
    const std::vector<Candidate> all = candidates(places);
    const Candidate* best = nullptr;
    double least = cost_;
    for (const Candidate& candidate : all) {
        const BrokenSites next = with(candidate);
        const double cost = can_say(next, candidate.place) ? cost_of(next) : infinite;
        if (!(cost < least)) continue;
        least = cost;
        best = &candidate;
    }
    if (!best) return false;
    take_at(with(*best), least);
    refine(best->place);
    return true;
}

std::vector<Pruning::Candidate> Pruning::candidates(std::span<const double> places) const {
    std::vector<Candidate> result;
    for (const double place : places) {
        for (const Kind kind : kinds()) result.push_back({gap_beside(place, 0), kind});
    }
    double last = fit_->domain().lo;
    for (const BrokenSite& site : sites_) {
        result.push_back({knot_between({last, site.at}), nullptr});
        last = site.at;
    }
    result.push_back({knot_between({last, fit_->domain().hi}), nullptr});
    return result;
}

BrokenSites Pruning::with(const Candidate& candidate) const {
    BrokenSites next = sites_;
    BrokenSite& site = next[site_at(next, candidate.place)];
    if (candidate.kind) {
        site.*candidate.kind = true;
    } else {
        ++site.times;
    }
    return next;
}

void Pruning::refine(double place) {
    BrokenSites copy = sites_;
    const std::size_t j = site_at(copy, place);
    for (const int step : refine_samples) {
        for (const int side : {-1, 1}) move_to(j, gap_beside(sites_[j].at, side * step));
    }
}

/// The breaks that are more than what a knot of this order is.
std::span<const Pruning::Kind> Pruning::kinds() const {
    return std::span<const Kind>(break_kinds).first(
        static_cast<std::size_t>(std::clamp(fit_->order() - 1, 0, 2)));
}

/// Whether one more knot leaves a break at the site something to say.
bool Pruning::has_room(const BrokenSite& site) const {
    return site.times < fit_->most_times() - (site.corner ? 2 : site.jump ? 1 : 0);
}

/// Whether a break at the place is not there already by the knots.
bool Pruning::can_say(const BrokenSites& sites, double place) const {
    for (const BrokenSite& site : sites) {
        if (site.at == place && site.alone() > 0) {
            return site.times <= fit_->order() - (site.corner ? 2 : 1);
        }
    }
    return true;
}

/// The middle of the gap between samples that holds `place`, or of one some gaps off; `place`
/// itself where there is none.
double Pruning::gap_beside(double place, int step) const {
    const std::span<const double> x = samples_->x;
    const std::ptrdiff_t i = std::upper_bound(x.begin(), x.end(), place) - x.begin() + step;
    if (i < 1 || i >= static_cast<std::ptrdiff_t>(x.size())) return place;
    const double lo = x[static_cast<std::size_t>(i - 1)], hi = x[static_cast<std::size_t>(i)];
    return lo + 0.5 * (hi - lo);
}

}  // namespace batten::fitting
