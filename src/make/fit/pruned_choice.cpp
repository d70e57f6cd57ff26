#include "make/fit/pruned_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "batten/base/text.hpp"
#include "make/fit/knot_moves.hpp"

namespace batten::fitting {
namespace {

constexpr int most_sweeps = 100;
constexpr double pruning_gain_enough = 0.01;  // of a criterion in which 2 is hardly worth mentioning
constexpr double move_shares[] = {0.5, 0.25, 0.1, 0.03, 0.01};  // of a gap: how far a knot is moved

/// One set of knots after the other, each cheaper than the one before.
class Pruning {
public:
    Pruning(FreeFit& fit, const Samples& samples, const KnotSet& start)
        : fit_(fit), samples_(samples), set_(start) {
        cost_ = cost_of(set_);
    }

    const KnotSet& set() const { return set_; }
    double delta2() { return fit_.value(set_); }

    /// Whether anything was gained.
    bool sweep() {
        const double before = cost_;
        take_out();
        move();
        stack();
        put_in();
        return cost_ < before - pruning_gain_enough;
    }

private:
    double cost_of(const KnotSet& set) {
        if (!is_ordered(fit_, set)) return infinite;
        const double delta2 = fit_.value(set), n = static_cast<double>(samples_.values());
        if (!std::isfinite(delta2)) return delta2;
        // Where delta2 enters by its logarithm, interpolation would always win.
        const int p = fit_.parameters_of(set);
        if (!samples_.sigma_known && 2 * p > static_cast<int>(samples_.values())) return infinite;
        const double least = std::max(samples_.least_delta2, tiny);
        const double misfit =
            samples_.sigma_known ? delta2 : n * std::log(std::max(delta2, least));
        return misfit + std::log(n) * p;
    }

    bool take(const KnotSet& next) {
        const double cost = cost_of(next);
        if (!(cost < cost_)) return false;
        set_ = next;
        cost_ = cost;
        return true;
    }

    double before(std::size_t j) const { return j == 0 ? fit_.domain().lo : set_.at[j - 1]; }
    double after(std::size_t j) const {
        return j + 1 == set_.size() ? fit_.domain().hi : set_.at[j + 1];
    }

    void take_out() {
        for (std::size_t j = set_.size(); j-- > 0;) {
            while (j < set_.size() && take(fewer(set_, j))) {}
        }
    }

    /// Every site to where it serves better between its neighbours, long ways first.
    void move() {
        for (std::size_t j = 0; j < set_.size(); ++j) {
            for (const double share : move_shares) {
                for (const double side : {-1.0, 1.0}) {
                    const double gap = side < 0 ? set_.at[j] - before(j) : after(j) - set_.at[j];
                    KnotSet next = set_;
                    next.at[j] += side * share * gap;
                    take(next);
                }
            }
        }
    }

    /// One knot of a site to its neighbour.
    void stack() {
        for (std::size_t j = 0; j < set_.size(); ++j) {
            for (const int side : {-1, 1}) {
                const std::size_t to = j + static_cast<std::size_t>(side);
                if (to >= set_.size() || set_.times[to] >= fit_.most_times()) continue;
                KnotSet next = set_;
                ++next.times[to];
                if (take(fewer(next, j))) break;
            }
        }
    }

    /// One more knot at a site, or in the middle between two.
    void put_in() {
        for (std::size_t j = 0; j < set_.size(); ++j) {
            if (set_.times[j] >= fit_.most_times()) continue;
            KnotSet next = set_;
            ++next.times[j];
            take(next);
        }
        for (std::size_t gap = 0; gap <= set_.size(); ++gap) {
            const double lo = gap == 0 ? fit_.domain().lo : set_.at[gap - 1];
            const double hi = gap == set_.size() ? fit_.domain().hi : set_.at[gap];
            KnotSet next = set_;
            next.at.insert(next.at.begin() + static_cast<std::ptrdiff_t>(gap),
                           knot_between({lo, hi}));
            next.times.insert(next.times.begin() + static_cast<std::ptrdiff_t>(gap), 1);
            take(next);
        }
    }

    static KnotSet fewer(const KnotSet& set, std::size_t j) {
        KnotSet next = set;
        if (--next.times[j] > 0) return next;
        next.at.erase(next.at.begin() + static_cast<std::ptrdiff_t>(j));
        next.times.erase(next.times.begin() + static_cast<std::ptrdiff_t>(j));
        return next;
    }

    static constexpr double infinite = std::numeric_limits<double>::infinity();
    static constexpr double tiny = std::numeric_limits<double>::min();
    FreeFit& fit_;
    const Samples& samples_;
    KnotSet set_;
    double cost_ = 0;
};

}  // namespace

void note_stacks(KnotChoice& choice, const KnotSet& set, int order) {
    for (std::size_t j = 0; j < set.size(); ++j) {
        if (set.times[j] < order - 1 || set.times[j] < 2) continue;
        const char* const what = set.times[j] == order ? "knots: a jump at " : "knots: a corner at ";
        choice.notes.push_back(what + format_number(set.at[j]) + ", where " +
                               std::to_string(set.times[j]) + " stand");
    }
}

KnotChoice pruned_knots(const Samples& samples, const LocalBasis& basis,
                        const FitOptions& options) {
    FitOptions insertion = options;
    insertion.knots = KnotPlacement::automatic;
    insertion.robust = Robust::none;
    KnotChoice choice = choose_knots(samples, basis, insertion);
    choice.alternatives.clear();
    choice.notes.clear();
    const KnotSet start = KnotSet::of(choice.knots, samples.range);
    FreeFit fit(samples, basis, ends_of(options));
    Pruning pruning(fit, samples, start);
    int sweeps = 0;
    while (sweeps < most_sweeps && pruning.sweep()) ++sweeps;
    choice.is_converged = sweeps < most_sweeps;
    choice.knots = fit.knots_of(pruning.set());
    choice.moved = pruning.set().count();
    if (samples.sides.size() == 1) note_stacks(choice, pruning.set(), basis.order());
    return choice;
}

}  // namespace batten::fitting
