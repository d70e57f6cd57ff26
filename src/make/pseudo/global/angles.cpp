#include "make/pseudo/global/angles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "make/pseudo/global/descent.hpp"
#include "make/pseudo/global/unknowns.hpp"
#include "make/pseudo/segment/angles.hpp"
#include "make/pseudo/three_point.hpp"

namespace batten::pseudo {
namespace {

/// A change dies away by a factor of 0.3 or so from point to point: beyond four spans to either
/// side it cannot turn a gain into a loss.
constexpr std::size_t window_reach = 4;

constexpr int most_steps = 200;
constexpr int most_window_steps = 40;
constexpr int most_sweeps = 10;
constexpr double least_gain = 1e-12;

/// From one valley to the next it is some 0.1 to 0.2 rad (Table 1, y = 3, 5).
constexpr double kick = 0.3;

double longest_of(const std::vector<SpanAngles>& spans) {
    double longest = 0;
    for (const SpanAngles& span : spans) longest = std::fmax(longest, span.length);
    return longest;
}

/// The local result's spans on their least minima, weighed by the longest chord's measure, so that
/// points x 2^k give the same bits.
std::vector<WeighedSpan> weighed(const std::vector<SpanAngles>& spans, double exponent,
                                 const Progress& progress) {
    const double longest = longest_of(spans);
    std::vector<WeighedSpan> result;
    for (const SpanAngles& span : spans) {
        result.push_back({relative_weight(span.length / longest, exponent),
                          expand_minimum(least_minimum(span.theta0, span.theta1))});
        progress.at(result.size(), spans.size());
    }
    return result;
}

/// A way down that ends where no change of a single span or tangent leads further.
class Search {
public:
    Search(std::vector<WeighedSpan> spans, const Unknowns& unknowns)
        : spans_(std::move(spans)), unknowns_(unknowns) {}

    void run(const Progress& progress);
    /// The spans where the search has ended, with the sum and its gradient.
    GlobalDescent end() const { return {spans_, unknowns_}; }
    int steps() const { return steps_; }
    bool is_converged() const { return steps_ < most_steps; }

private:
    /// Neighbouring spans to try changes on: `middle` is the place of the span in question.
    struct Window {
        std::size_t first, middle;
        Unknowns unknowns;
        std::vector<WeighedSpan> spans;
    };

    void settle(const Progress& alive);
    bool try_all(std::size_t span);
    Window around(std::size_t span) const;
    bool keep_if_lower(const Window& window, const std::vector<WeighedSpan>& changed);
    bool try_rivals(std::size_t span);
    bool try_kicks(std::size_t span);

    std::vector<WeighedSpan> spans_;
    const Unknowns& unknowns_;
    int steps_ = 0;
};

void Search::settle(const Progress& alive) {
    GlobalDescent descent(std::move(spans_), unknowns_);
    do {
        steps_ += descent.settle(most_steps - steps_, alive);
    } while (is_converged() && descent.pass_to_least(alive));
    spans_ = descent.spans();
}

Search::Window Search::around(std::size_t span) const {
    const std::size_t n = spans_.size();
    const std::size_t size = std::min(n, 2 * window_reach + 1);
    const std::size_t before = std::min(window_reach, n - 1);
    const std::size_t first = (span + n - before) % n;
    Window window{first, before, within_window(unknowns_, first, size), {}};
    for (std::size_t k = 0; k < size; ++k) window.spans.push_back(spans_[(first + k) % n]);
    return window;
}

/// Lets the changed window settle while all else stands still.
bool Search::keep_if_lower(const Window& window, const std::vector<WeighedSpan>& changed) {
    const double before = GlobalDescent(window.spans, window.unknowns).energy();
    GlobalDescent settled(changed, window.unknowns);
    settled.settle(most_window_steps);
    if (!(settled.energy() < before * (1 - least_gain))) return false;
    for (std::size_t k = 0; k < changed.size(); ++k) {
        spans_[(window.first + k) % spans_.size()] = settled.spans()[k];
    }
    return true;
}

bool Search::try_rivals(std::size_t span) {
    const Window window = around(span);
    const PseudoSegment now = window.spans[window.middle].energy.minimum.segment;
    for (const Minimum& rival : central_minima(now.theta0, now.theta1)) {
        std::vector<WeighedSpan> changed = window.spans;
        changed[window.middle].energy = expand_minimum(rival);
        if (keep_if_lower(window, changed)) return true;
    }
    return false;
}

/// Turns the tangent at the end of a span far enough to leave its valley.
bool Search::try_kicks(std::size_t span) {
    const Window window = around(span);
    const std::size_t unknown = window.unknowns.of_span[window.middle].end;
    if (unknown == SpanUnknowns::fixed) return false;
    for (const double turn : {-kick, kick}) {
        std::vector<WeighedSpan> changed = window.spans;
        for (std::size_t k = 0; k < changed.size(); ++k) {
            const SpanUnknowns ends = window.unknowns.of_span[k];
            if (ends.start != unknown && ends.end != unknown) continue;
            PseudoSegment s = changed[k].energy.minimum.segment;
            if (ends.start == unknown) s.theta0 += turn;
            if (ends.end == unknown) s.theta1 += turn;
            changed[k].energy = expand_minimum(least_minimum(s.theta0, s.theta1));
        }
        if (keep_if_lower(window, changed)) return true;
    }
    return false;
}

bool Search::try_all(std::size_t span) {
    const bool has_passed = try_rivals(span);
    return try_kicks(span) || has_passed;
}

void Search::run(const Progress& progress) {
    settle(progress.stage(0, 0));
    const std::size_t n = spans_.size();
    std::vector<bool> is_due(n, true);
    bool has_changed = true;
    for (int k = 0; k < most_sweeps && has_changed; ++k) {
        has_changed = false;
        std::vector<bool> is_due_again(n, false);
        // Each sweep has far fewer spans to try than the one before.
        const Progress sweep = progress.stage(1 - std::ldexp(1, -3 * k), 1 - std::ldexp(1, -3 * k - 3));
        for (std::size_t i = 0; i < n; ++i) {
            sweep.at(i, n);
            if (!is_due[i] || !try_all(i)) continue;
            has_changed = true;
            const std::size_t first = i + n - std::min(window_reach, n - 1);
            for (std::size_t j = first; j <= i + n + window_reach; ++j) is_due_again[j % n] = true;
        }
        is_due = std::move(is_due_again);
        if (has_changed) settle(sweep.stage(1, 1));
    }
}

}  // namespace

GlobalSpline global_angles(PointsView points, const AngleRules& rules) {
    const Unknowns unknowns = number_unknowns(points.size(), rules);
    AngleRules first = rules;
    first.progress = rules.progress.stage(0, 0.05);
    const std::vector<SpanAngles> local = local_angles(points, first);
    const double unit = std::pow(longest_of(local), rules.weight_exponent);
    Search search(weighed(local, rules.weight_exponent, rules.progress.stage(0.05, 0.1)), unknowns);
    search.run(rules.progress.stage(0.1, 1));

    const GlobalDescent end = search.end();
    GlobalSpline result{local, {}, unit * end.energy(), unit * end.largest_gradient()};
    result.steps = search.steps();
    if (search.is_converged()) result.status = GlobalStatus::converged;
    for (std::size_t i = 0; i < local.size(); ++i) {
        Minimum minimum = end.spans()[i].energy.minimum;
        minimum.segment.theta0 = result.spans[i].theta0 = wrap(minimum.segment.theta0);
        minimum.segment.theta1 = result.spans[i].theta1 = wrap(minimum.segment.theta1);
        result.minima.push_back(minimum);
    }
    return result;
}

}  // namespace batten::pseudo
