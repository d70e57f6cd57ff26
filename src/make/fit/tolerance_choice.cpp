#include "make/fit/tolerance_choice.hpp"

#include <algorithm>
#include <cmath>

#include "make/fit/fixed_fit.hpp"
#include "make/fit/free_choice.hpp"
#include "make/fit/interval_rows.hpp"
#include "make/fit/knot_descent.hpp"
#include "make/fit/residuals.hpp"

namespace batten::fitting {
namespace {

constexpr int steps_of_a_trial = 30;
constexpr int sites_tried = 4;  // knots whose removal is followed by a descent
constexpr int most_grown = 16;               // knots: of so few the best sets are sought afresh
constexpr std::size_t samples_grown = 4096;  // a search looks at them some thousand times
constexpr std::size_t most_moved = 40;  // knots: a descent costs their cube

/// Fits over breaks or knots and their largest residuals, against one tolerance.
class Sieve {
public:
    Sieve(const Samples& samples, const LocalBasis& basis, Ends ends, double tolerance,
          const Limit& limit)
        : samples_(samples), basis_(basis), ends_(ends), tolerance_(tolerance), limit_(limit) {}

    /// Fits. False where the samples do not determine the spline.
    bool fit(const std::vector<double>& breaks) {
        samples_.work.step();
        const std::span<const double> inner(breaks.data() + 1, breaks.size() - 2);
        FixedFit fixed =
            solve_fixed(samples_,
                        ends_ == Ends::closed ? closed_knots(breaks, basis_.order())
                                              : open_knots(samples_.range, inner, basis_.order()),
                        basis_, ends_);
        if (!fixed.undetermined.empty()) return false;
        is_kept_ = limit_(fixed);
        splines_ = splines_of(fixed, samples_.sides.size());
        parameters_ = fixed.functions * static_cast<int>(samples_.directions());
        residuals_ = residuals_of(samples_, splines_);
        delta2_ = delta2_of(samples_, residuals_);
        largest_ = 0;
        for (const double e : residuals_) largest_ = std::max(largest_, std::fabs(e));
        return true;
    }
    bool is_within() const { return is_kept_ && largest_ <= tolerance_; }
    double delta2() const { return delta2_; }
    int parameters() const { return parameters_; }

    /// The middle sample's abscissa of every interval with a residual above the tolerance, the
    /// worst interval's first. Knots at samples: so the last of them can interpolate.
    std::vector<double> wanted(const std::vector<double>& breaks) const {
        struct Want {
            double largest, at;
        };
        std::vector<Want> wants;
        Rows rest{0, samples_.size()};
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
            const RightEnd end = i + 2 == breaks.size() ? RightEnd::closed : RightEnd::open;
            Rows rows = rows_in(samples_, rest, {breaks[i], breaks[i + 1]}, end);
            rest.first = rows.last;
            double largest = 0;
            for (std::size_t r = rows.first; r < rows.last; ++r) {
                largest = std::max(largest, std::fabs(residuals_[r]));
            }
            if (is_kept_ && largest <= tolerance_) continue;
            while (rows.count() > 0 && samples_.x[rows.first] == breaks[i]) ++rows.first;
            while (rows.count() > 0 && samples_.x[rows.last - 1] == breaks[i + 1]) --rows.last;
            if (rows.count() > 0) {
                wants.push_back({largest, samples_.x[rows.first + rows.count() / 2]});
            }
        }
        std::stable_sort(wants.begin(), wants.end(),
                         [](const Want& a, const Want& b) { return a.largest > b.largest; });
        std::vector<double> result;
        for (const Want& want : wants) result.push_back(want.at);
        return result;
    }

    /// Inner breaks, that with the least jump of the highest derivative first. fit(breaks) came
    /// last.
    std::vector<std::size_t> by_jump(const std::vector<double>& breaks) const {
        std::vector<double> jump(breaks.size(), 0.0);
        std::vector<std::size_t> order;
        const int degree = basis_.order() - 1;
        for (std::size_t i = 1; i + 1 < breaks.size(); ++i) {
            const double reach = std::min(breaks[i] - breaks[i - 1], breaks[i + 1] - breaks[i]);
            for (const SplineFunction& s : splines_) {
                jump[i] += std::fabs(s.value_on(i, breaks[i], degree) -
                                     s.value_on(i - 1, breaks[i], degree)) *
                           std::pow(reach, degree);
            }
            order.push_back(i);
        }
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return jump[a] < jump[b]; });
        return order;
    }

private:
    const Samples& samples_;
    const LocalBasis& basis_;
    Ends ends_;
    double tolerance_;
    const Limit& limit_;
    bool is_kept_ = true;
    std::vector<SplineFunction> splines_;
    std::vector<double> residuals_;
    int parameters_ = 0;
    double largest_ = 0, delta2_ = 0;
};

std::vector<double> without(const std::vector<double>& breaks, std::size_t i) {
    std::vector<double> fewer = breaks;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    return fewer;
}

std::vector<double> with(std::vector<double> breaks, double at) {
    breaks.insert(std::upper_bound(breaks.begin(), breaks.end(), at), at);
    return breaks;
}

/// `breaks` with all knots wanted, or with as many of them as the samples can determine.
std::vector<double> finer_breaks(Sieve& sieve, const std::vector<double>& breaks) {
    const std::vector<double> wanted = sieve.wanted(breaks);
    std::vector<double> finer = breaks;
    for (const double at : wanted) finer = with(std::move(finer), at);
    if (sieve.fit(finer)) return finer;
    finer = breaks;
    for (const double at : wanted) {
        std::vector<double> next = with(finer, at);
        if (sieve.fit(next)) finer = std::move(next);
    }
    return finer;
}

/// Takes knots out as long as that stays within.
std::vector<double> thinned(Sieve& sieve, std::vector<double> breaks) {
    for (bool gains = true; gains;) {
        gains = false;
        sieve.fit(breaks);
        std::vector<double> sites;
        for (const std::size_t i : sieve.by_jump(breaks)) sites.push_back(breaks[i]);
        for (const double site : sites) {
            const auto at = std::lower_bound(breaks.begin(), breaks.end(), site);
            std::vector<double> fewer =
                without(breaks, static_cast<std::size_t>(at - breaks.begin()));
            if (!sieve.fit(fewer) || !sieve.is_within()) continue;
            breaks = std::move(fewer);
            gains = true;
        }
    }
    return breaks;
}

/// The same, the knots left being moved.
std::vector<double> moved_and_thinned(Sieve& sieve, FreeFit& fit, std::vector<double> breaks) {
    for (bool gains = breaks.size() <= most_moved + 2; gains;) {
        gains = false;
        sieve.fit(breaks);
        std::vector<std::size_t> order = sieve.by_jump(breaks);
        order.resize(std::min<std::size_t>(order.size(), sites_tried));
        for (const std::size_t i : order) {
            const std::vector<double> fewer = without(breaks, i);
            KnotSet set{{fewer.begin() + 1, fewer.end() - 1},
                        std::vector<int>(fewer.size() - 2, 1)};
            const Descent d = newton_descent(fit, std::move(set), steps_of_a_trial);
            const bool is_simple = d.set.count() == static_cast<int>(d.set.size());
            if (!std::isfinite(d.delta2) || !is_simple) continue;
            std::vector<double> next{breaks.front()};
            next.insert(next.end(), d.set.at.begin(), d.set.at.end());
            next.push_back(breaks.back());
            if (!sieve.fit(next) || !sieve.is_within()) continue;
            breaks = std::move(next);
            gains = true;
            break;
        }
    }
    return breaks;
}

/// Fewer knots than `breaks` has, grown one by one from none, each number of them moved to where
/// delta2 is least.
std::vector<double> grown_afresh(Sieve& sieve, FreeFit& fit, std::vector<double> breaks) {
    const Interval domain{breaks.front(), breaks.back()};
    const int most = static_cast<int>(breaks.size()) - 3;
    if (most < 0 || most > most_grown) return breaks;
    const auto breaks_of = [&](const KnotSet& set) {
        std::vector<double> result{domain.lo};
        for (std::size_t v = 0; v < set.size(); ++v) {
            result.insert(result.end(), static_cast<std::size_t>(set.times[v]), set.at[v]);
        }
        result.push_back(domain.hi);
        return result;
    };
    const std::optional<KnotSet> fewer = fewest_free(fit, most, [&](const KnotSet& set) {
        return sieve.fit(breaks_of(set)) && sieve.is_within();
    });
    return fewer ? breaks_of(*fewer) : breaks;
}

}  // namespace

KnotChoice knots_within(const Samples& samples, const LocalBasis& basis,
                        const FitOptions& options, const Limit& limit) {
    double extent = 0;
    for (const std::span<const double> side : samples.sides) {
        const auto [lo, hi] = std::minmax_element(side.begin(), side.end());
        extent = std::max(extent, *hi - *lo);
    }
    const Ends ends = ends_of(options);
    Sieve sieve(samples, basis, ends, options.tolerance->in_units(extent), limit);
    std::vector<double> breaks{samples.range.lo, samples.range.hi};
    KnotChoice choice;
    choice.by_data = true;
    while (sieve.fit(breaks)) {
        choice.path.push_back(step_of(sieve.delta2(), samples.values(), sieve.parameters(),
                                      static_cast<int>(breaks.size()) - 1,
                                      samples.sigma_known ? SigmaKnowledge::known
                                                          : SigmaKnowledge::unknown));
        if (sieve.is_within()) break;
        std::vector<double> finer = finer_breaks(sieve, breaks);
        if (finer.size() == breaks.size()) break;
        breaks = std::move(finer);
    }
    choice.is_met = sieve.fit(breaks) && sieve.is_within();
    if (choice.is_met) {
        breaks = thinned(sieve, std::move(breaks));
        if (basis.order() > 1) {
            FreeFit fit(samples, basis, ends);
            std::vector<double> moved = moved_and_thinned(sieve, fit, breaks);
            if (ends == Ends::open && samples.size() <= samples_grown) {
                moved = grown_afresh(sieve, fit, std::move(moved));
            }
            choice.moved = moved.size() < breaks.size() ? static_cast<int>(moved.size()) - 2 : 0;
            breaks = moved;
        }
    }
    choice.knots = ends == Ends::closed
                       ? closed_knots(breaks, basis.order())
                       : open_knots(samples.range, {breaks.data() + 1, breaks.size() - 2},
                                    basis.order());
    return choice;
}

}  // namespace batten::fitting
