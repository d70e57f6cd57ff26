#include "make/fit_surface/choice.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit_surface/lattice.hpp"
#include "make/fit_surface/moved_lines.hpp"
#include "make/fit_surface/surface_options.hpp"

namespace batten::surface_fitting {
namespace {

constexpr double equally_good = 1e-9;  // relative difference of two criteria that is none
constexpr int least_strips = 45;  // in both directions together, as for curves

/// What decides on the number of strips.
struct Target {
    StopRule rule = StopRule::bic;
    Psi phi{};
    std::array<int, 2> exactly{};  ///< 0: the rule decides
    double delta2 = 0;             ///< 0: not asked
};

SurfaceStep step_of(const Lattice& lattice) {
    const Misfit& misfit = lattice.misfit();
    const int parameters = lattice.parameters();
    SurfaceStep step{
        fit_criteria(std::max(misfit.delta2, lattice.least_delta2()), lattice.samples(), parameters,
                     lattice.knows_sigma() ? SigmaKnowledge::known : SigmaKnowledge::unknown),
        {lattice.x_strips(), lattice.y_strips()},
        parameters,
        {}};
    step.delta2 = misfit.delta2;
    if (!misfit.psi_is_missing) step.psi.assign(misfit.psi.begin(), misfit.psi.end());
    return step;
}

/// The search for lines: what there was, and whether to go on.
class LineSearch {
public:
    LineSearch(Lattice& lattice, const Target& target) : lattice_(lattice), target_(target) {}

    bool step_wants_more() {
        if (!lattice_.refit()) {
            require_a_step();
            is_cut_off_ = true;
            return false;
        }
        steps_.push_back(step_of(lattice_));
        x_breaks_.push_back(lattice_.x_breaks());
        y_breaks_.push_back(lattice_.y_breaks());
        return wants_more(steps_.back());
    }

    /// The strip to be halved next fits as badly as another one.
    void see_tie() { ties_.push_back(steps_.size() - 1); }

    SurfaceChoice finish() {
        std::size_t chosen = steps_.size() - 1;
        const bool is_free = target_.exactly[0] == 0 && target_.delta2 == 0;
        if (is_free && is_criterion(target_.rule)) {
            for (std::size_t i = steps_.size(); i-- > 0;) {
                if (value(i) <= value(chosen)) chosen = i;
            }
        }
        const int degree = lattice_.degree();
        SurfaceChoice choice{clamped_knots(x_breaks_[chosen], degree),
                             clamped_knots(y_breaks_[chosen], degree), {}, {}, 0, is_met_};
        if (std::optional<Lattice::Fit> fit =
                lattice_.known_fit(x_breaks_[chosen], y_breaks_[chosen])) {
            choice.x = std::move(fit->x);
            choice.y = std::move(fit->y);
            choice.solution = std::move(fit->solution);
            choice.misfit = std::move(fit->misfit);
        }
        tell_why_it_ended(choice, chosen);
        choice.path = std::move(steps_);
        if (is_cut_off_) {
            choice.notes.push_back("the search ended early: strips so narrow, or lines and errors "
                                   "so uneven, are searched with the grid in memory only");
        }
        return choice;
    }

private:
    void require_a_step() const {
        if (!steps_.empty()) return;
        throw Error("fit-surface.streamed", "knots", "auto",
                    "lines or errors so uneven are searched with the grid in memory only: give "
                    "knot lines");
    }

    double value(std::size_t i) const { return criterion_of(steps_[i], target_.rule); }

    /// Where not the rule ended the search but what the nodes allow; and what is equally good.
    void tell_why_it_ended(SurfaceChoice& choice, std::size_t chosen) const {
        const auto strips = [&](std::size_t i) {
            return std::to_string(steps_[i].intervals[0]) + " x " +
                   std::to_string(steps_[i].intervals[1]);
        };
        const std::size_t last = steps_.size() - 1;
        const auto ties = std::count_if(ties_.begin(), ties_.end(),
                                        [&](std::size_t step) { return step < chosen; });
        if (ties > 0) {
            choice.notes.push_back("tie: at " + strips(ties_.front()) +
                                   " two strips fit equally badly; the first is halved, x before y" +
                                   (ties > 1 ? ", and so in " + std::to_string(ties - 1) +
                                                   " later steps"
                                             : ""));
        }
        if (!is_met_) {
            choice.notes.push_back("intervals: the data determine no more than " + strips(last));
            return;
        }
        if (target_.exactly[0] > 0 || target_.delta2 > 0 || !is_criterion(target_.rule)) return;
        if (chosen == last && last > 0) {
            choice.notes.push_back("intervals: the criterion was still falling at " + strips(last) +
                                   ", as many as the data determine");
        }
        for (std::size_t i = 0; i <= last; ++i) {
            if (i == chosen || std::fabs(value(i) - value(chosen)) >
                                   equally_good * std::fabs(value(chosen))) {
                continue;
            }
            choice.notes.push_back("tie: " + strips(i) + " and " + strips(chosen) +
                                   " strips are equally good; the fewer are taken");
        }
    }

    bool wants_more(const SurfaceStep& step) {
        const std::size_t count = lattice_.samples();
        if (target_.exactly[0] > 0) {
            is_met_ = step.intervals == target_.exactly;
            return !is_met_;
        }
        const double degrees = static_cast<double>(count) - step.parameters;
        if (target_.delta2 > 0) {
            is_met_ = step.delta2 <= target_.delta2;
        } else if (target_.rule == StopRule::distribution) {
            is_met_ = is_distributed(step.psi, target_.phi);
        } else if (target_.rule == StopRule::chi2) {
            is_met_ = degrees > 0 && step.delta2 <= chi2_quantile(0.05, degrees);
        } else {
            return reaches_on(step);
        }
        return !is_met_;
    }

    bool reaches_on(const SurfaceStep& step) {
        if (steps_.size() == 1 || value(steps_.size() - 1) < best_) {
            best_ = value(steps_.size() - 1);
            best_strips_ = step.intervals[0] + step.intervals[1];
        }
        // Where delta2 enters by its logarithm, interpolation would always win.
        const bool is_bounded = target_.rule == StopRule::bic && lattice_.knows_sigma();
        const std::size_t twice = 2 * static_cast<std::size_t>(step.parameters);
        if (!is_bounded && twice > lattice_.samples()) return false;
        return step.intervals[0] + step.intervals[1] < std::max(least_strips, 2 * best_strips_);
    }

    Lattice& lattice_;
    const Target& target_;
    std::vector<SurfaceStep> steps_;
    std::vector<std::vector<double>> x_breaks_, y_breaks_;
    std::vector<std::size_t> ties_;  ///< steps at which two strips fitted equally badly
    double best_ = 0;
    int best_strips_ = 2;
    bool is_met_ = true;
    bool is_cut_off_ = false;
};

/// Whether there are as many nodes as so many strips have coefficients.
bool has_nodes_for(const Lattice& lattice, int x_strips, int y_strips) {
    const double x = x_strips + lattice.degree(), y = y_strips + lattice.degree();
    return x * y <= static_cast<double>(lattice.samples());
}

bool try_equal(Lattice& lattice, int x_strips, int y_strips) {
    return has_nodes_for(lattice, x_strips, y_strips) && lattice.set_equal(x_strips, y_strips);
}

SurfaceChoice insert_lines(Lattice& lattice, const Target& target) {
    const bool counts = target.rule == StopRule::distribution && target.exactly[0] == 0 &&
                        target.delta2 == 0;
    lattice.expect_splits(counts ? Lattice::Residuals::each : Lattice::Residuals::sums);
    LineSearch search(lattice, target);
    while (search.step_wants_more()) {
        const std::optional<Lattice::Strip> strip = lattice.worst(target.exactly);
        if (!strip || !has_nodes_for(lattice, lattice.x_strips() + strip->is_x,
                                     lattice.y_strips() + !strip->is_x)) {
            break;
        }
        if (lattice.is_tied(*strip, target.exactly)) search.see_tie();
        lattice.split(*strip);
    }
    return search.finish();
}

SurfaceChoice equal_lines(Lattice& lattice, const Target& target) {
    if (target.exactly[0] > 0 && !lattice.set_equal(target.exactly[0], target.exactly[1])) {
        throw Error("fit.too-few", "intervals",
                    std::to_string(target.exactly[0]) + "," + std::to_string(target.exactly[1]),
                    "the nodes do not determine so many strips");
    }
    if (target.exactly[0] > 0) {
        return {clamped_knots(lattice.x_breaks(), lattice.degree()),
                clamped_knots(lattice.y_breaks(), lattice.degree()), {}, {}, 0, true};
    }
    LineSearch search(lattice, target);
    while (search.step_wants_more()) {
        const int m = lattice.x_strips(), n = lattice.y_strips();
        const bool is_x = lattice.is_x_worse();
        if (!try_equal(lattice, m + is_x, n + !is_x) && !try_equal(lattice, m + !is_x, n + is_x)) {
            break;
        }
    }
    return search.finish();
}

/// The full vector from knots as given: interior ones, or the ends too.
std::vector<double> given_knots(std::span<const double> given, Interval range,
                                int degree, const char* name) {
    std::vector<double> inside;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const bool is_end = given[i] == range.lo || given[i] == range.hi;
        const bool is_inside = range.lo < given[i] && given[i] < range.hi;
        const bool rises = i == 0 || given[i - 1] <= given[i];
        if (!rises || !(is_end || is_inside)) {
            throw Error("fit.knots", std::string(name) + ' ' + std::to_string(i + 1),
                        format_number(given[i]),
                        "knots must not fall and lie between the first and the last line");
        }
        if (is_inside) inside.push_back(given[i]);
    }
    const std::size_t most = static_cast<std::size_t>(std::max(degree, 1));
    for (std::size_t i = most; i < inside.size(); ++i) {
        if (inside[i - most] < inside[i]) continue;
        throw Error("fit.knots", name, format_number(inside[i]),
                    "a knot line is repeated at most " + std::to_string(most) + " times");
    }
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, range.lo);
    knots.insert(knots.end(), inside.begin(), inside.end());
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, range.hi);
    return knots;
}

Target target_of(const FitSurfaceOptions& options) {
    Target target{options.stop, error_distribution(options.distribution)};
    target.delta2 = options.delta2.value_or(0);
    if (options.intervals.empty()) return target;
    if (options.intervals.size() != 2) {
        throw Error("fit.intervals", "intervals", std::to_string(options.intervals.size()),
                    "two numbers M,N are needed");
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const double n = options.intervals[i];
        if (!(n >= 1) || n != std::floor(n) || n > 1e5) {
            throw Error("fit.intervals", "intervals", format_number(n),
                        "must be a whole number from 1 to 1e5");
        }
        target.exactly[i] = static_cast<int>(n);
    }
    return target;
}

Interval ends_of(std::span<const double> lines) { return {lines.front(), lines.back()}; }

SurfaceChoice searched_lines(Lattice& lattice, const FitSurfaceOptions& options,
                             const Target& target) {
    const bool is_even = options.knots == SurfaceKnots::equal ||
                         (options.knots == SurfaceKnots::free && !options.intervals.empty());
    return is_even ? equal_lines(lattice, target) : insert_lines(lattice, target);
}

/// Of nodes or a cloud.
template <class Data>
SurfaceChoice moved_where_free(const Data& data, const FitSurfaceOptions& options,
                               SurfaceChoice choice) {
    if (options.knots != SurfaceKnots::free) return choice;
    MovedLines moved = move_lines(data, {std::move(choice.x_knots), std::move(choice.y_knots)},
                                  options.degree);
    choice.solution.reset();
    choice.x.reset();
    choice.y.reset();
    choice.x_knots = std::move(moved.knots[0]);
    choice.y_knots = std::move(moved.knots[1]);
    choice.moved = moved.moved;
    choice.is_converged = moved.is_converged;
    if (!moved.is_converged) {
        choice.notes.push_back("knots: the lines had not come to rest after " +
                               std::to_string(moved.steps) + " steps; the last one lessened delta2 "
                               "by " + format_number(std::round(1e8 * moved.last_gain) / 1e6) +
                               " %");
    }
    return choice;
}

}  // namespace

std::vector<double> clamped_knots(std::span<const double> breaks, int degree) {
    std::vector<double> knots(static_cast<std::size_t>(degree), breaks.front());
    knots.insert(knots.end(), breaks.begin(), breaks.end());
    knots.insert(knots.end(), static_cast<std::size_t>(degree), breaks.back());
    return knots;
}

SurfaceChoice choose_lines(const Nodes& nodes, const FitSurfaceOptions& options) {
    require_surface_options(options);
    const Target target = target_of(options);
    if (has_given_lines(options)) {
        SurfaceChoice choice;
        choice.x_knots = given_knots(options.x_knots, ends_of(nodes.x), options.degree, "x_knots");
        choice.y_knots = given_knots(options.y_knots, ends_of(nodes.y), options.degree, "y_knots");
        return moved_where_free(nodes, options, std::move(choice));
    }
    Lattice lattice(nodes, options.degree, options.rule);
    return moved_where_free(nodes, options, searched_lines(lattice, options, target));
}

SurfaceChoice choose_lines(const Cloud& cloud, const FitSurfaceOptions& options) {
    require_surface_options(options);
    const Target target = target_of(options);
    const bool needs_errors = options.stop == StopRule::distribution ||
                              options.stop == StopRule::chi2;
    if (needs_errors && !cloud.sigma_known) {
        throw Error("fit.options", "stop", std::string(name_of(options.stop)),
                    "this rule needs the errors of the heights");
    }
    if (has_given_lines(options)) {
        SurfaceChoice choice;
        choice.x_knots = given_knots(options.x_knots, cloud.domain.x, options.degree, "x_knots");
        choice.y_knots = given_knots(options.y_knots, cloud.domain.y, options.degree, "y_knots");
        return moved_where_free(cloud, options, std::move(choice));
    }
    Lattice lattice(cloud, options.degree, options.rule);
    return moved_where_free(cloud, options, searched_lines(lattice, options, target));
}

}  // namespace batten::surface_fitting
