#include "make/log_aesthetic/spline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "batten/base/interval.hpp"
#include "make/log_aesthetic/span.hpp"
#include "num/banded.hpp"

namespace batten::spiral {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int most_newton_steps = 12;
constexpr int most_relaxing_steps = 300;
constexpr double longest_step = 0.6;  ///< of a tangent, radians
constexpr double met_sq = 1e-23;      ///< sum of squared jumps and misses that rounding explains
/// No tangent goes further from its chords: beyond, arcs become loops that grow without end.
constexpr double widest_angle = 2.4;
/// A smooth spline is taken with longer arcs than that, but not with loops.
constexpr double loop_angle = 3;
constexpr double loop_reach = 0.04;  ///< chord over length
constexpr double hopeless = 1e300;

/// `angle` as seen from 0, in (-pi, pi].
double folded(double angle) { return angle - 2 * pi * std::round(angle / (2 * pi)); }

/// A curvature times its chord, and how it moves with the span's two tangents.
struct EndCurvature {
    double value = 0, by_first = 0, by_second = 0;
};

/// A span with its unknowns eliminated: bends and end curvatures are linear in the two tangents.
struct Linear {
    EndCurvature start, end;
    EndCurvature start_bend, end_bend;  ///< corrections of the bends
    double reach = 1;
};

/// The tangents and bends of all spans: what a step moves.
struct State {
    std::vector<double> angles;
    std::vector<Bends> bends;
    double merit = hopeless;  ///< sum of the squared jumps and misses
};

class Spline {
public:
    Spline(const SplineRun& run, double alpha)
        : run_(run), alpha_(alpha), spans_(run.lengths.size()),
          points_(run.closed ? spans_ : spans_ + 1), starts_(spans_), ends_(spans_),
          linear_(spans_), shares_(points_), change_(points_), held_(points_) {}

    SplineChain solve();

private:
    double angle0(std::size_t span, const State& s) const {
        return s.angles[span] - starts_[span];
    }
    double angle1(std::size_t span, const State& s) const {
        return s.angles[next(span)] - ends_[span];
    }
    std::size_t next(std::size_t span) const { return span + 1 == points_ ? 0 : span + 1; }
    bool is_fixed(std::size_t point) const {
        return held_[point] || (!run_.fixed.empty() && run_.fixed[point].has_value());
    }
    bool has_before(std::size_t point) const { return run_.closed || point > 0; }
    bool has_after(std::size_t point) const { return run_.closed || point + 1 < points_; }
    std::size_t before(std::size_t point) const { return point == 0 ? spans_ - 1 : point - 1; }

    State start();
    /// Arcs that meet their chords at the present tangents, each for itself; whether all do.
    bool settle_all(State& state) const;
    /// Fills linear_ and the state's merit.
    void linearise(State& state);
    num::TridiagonalRow row(std::size_t point, double drag) const;
    double jump(std::size_t point) const;
    void find_change(double drag);
    State moved(const State& state) const;
    bool newton(State& state);
    bool has_no_loops(const State& state) const;
    bool relax(State& state);
    Interval bounds(std::size_t point) const;
    void hold_at_bounds(const State& state);
    bool release(const State& state);
    SplineChain chain(State state, bool converged);

    const SplineRun& run_;
    double alpha_;
    std::size_t spans_, points_;
    /// Directions of the chords, on the turn on which the tangents at their ends began.
    std::vector<double> starts_, ends_;
    std::vector<Linear> linear_;
    std::vector<double> shares_, change_;
    std::vector<char> held_;  ///< tangents that have reached their bound
    int steps_ = 0;
};

/// Tangents between the chords' directions, the shorter chord having its way; ends as on a circle.
State Spline::start() {
    State state{std::vector<double>(points_), std::vector<Bends>(spans_)};
    for (std::size_t i = 0; i < points_; ++i) {
        if (!has_before(i) || !has_after(i)) continue;
        const std::size_t j = before(i);
        const double turn = folded(run_.directions[i] - run_.directions[j]);
        const double share = run_.lengths[j] / (run_.lengths[j] + run_.lengths[i]);
        state.angles[i] = run_.directions[j] + turn * share;
    }
    if (!run_.closed) {
        const std::size_t last = points_ - 1;
        const bool is_line = points_ == 2;
        state.angles[0] = is_line ? run_.directions[0]
                                  : run_.directions[0] -
                                        0.5 * folded(state.angles[1] - run_.directions[0]);
        state.angles[last] =
            is_line ? run_.directions[0]
                    : run_.directions[last - 1] +
                          0.5 * folded(run_.directions[last - 1] - state.angles[last - 1]);
    }
    for (std::size_t i = 0; i < run_.fixed.size(); ++i) {
        if (run_.fixed[i]) state.angles[i] = *run_.fixed[i];
    }
    for (std::size_t i = 0; i < spans_; ++i) {
        const double first = state.angles[i], second = state.angles[next(i)];
        starts_[i] = first - folded(first - run_.directions[i]);
        ends_[i] = second - folded(second - run_.directions[i]);
        state.bends[i] = straight_bends(angle0(i, state), angle1(i, state));
    }
    return state;
}

bool Spline::settle_all(State& state) const {
    bool all = true;
    for (std::size_t i = 0; i < spans_; ++i) {
        const double a = angle0(i, state), b = angle1(i, state);
        // From the nearly straight arc: from elsewhere one with more turns may be found.
        Bends bends = straight_bends(a, b);
        if (settle(alpha_, a, b, bends)) {
            state.bends[i] = bends;
        } else {
            all = false;
        }
    }
    return all;
}

void Spline::linearise(State& state) {
    double sum = 0;
    for (std::size_t i = 0; i < spans_; ++i) {
        const Bends bends = state.bends[i];
        const double first = angle0(i, state);
        const SpanJet jet = span_jet(alpha_, first, bends);
        const double c = jet.reach.real(), g = jet.reach.imag();
        // turn + turn' d = second - first, g + g' d + c dfirst = 0 for the change d of the bends.
        const double miss = angle1(i, state) - first - jet.turn;
        const double gs = jet.reach_start.imag(), ge = jet.reach_end.imag();
        const double scale = 1 / (jet.turn_start * ge - jet.turn_end * gs);
        Linear& out = linear_[i];
        const auto solved = [&](double turn, double side) {
            return Bends{(turn * ge - jet.turn_end * side) * scale,
                         (jet.turn_start * side - turn * gs) * scale};
        };
        const Bends d = solved(miss, -g), by_first = solved(-1, -c), by_second = solved(1, 0);
        out.start_bend = {d.start, by_first.start, by_second.start};
        out.end_bend = {d.end, by_first.end, by_second.end};
        const double cs = jet.reach_start.real(), ce = jet.reach_end.real();
        const auto reach = [&](const Bends& b) { return cs * b.start + ce * b.end; };
        out.start = {bends.start * c + c * d.start + bends.start * reach(d),
                     c * by_first.start + bends.start * (reach(by_first) - g),
                     c * by_second.start + bends.start * reach(by_second)};
        out.end = {bends.end * c + c * d.end + bends.end * reach(d),
                   c * by_first.end + bends.end * (reach(by_first) - g),
                   c * by_second.end + bends.end * reach(by_second)};
        out.reach = c;
        sum += g * g + miss * miss;
        if (!(c > 1e-3)) sum = hopeless;
    }
    for (std::size_t i = 0; i < points_; ++i) {
        if (!is_fixed(i)) sum += jump(i) * jump(i);
    }
    state.merit = sum < hopeless ? sum : hopeless;
}

/// The jump that the linear spans have with the present tangents, times the shorter chord.
double Spline::jump(std::size_t i) const {
    if (!has_before(i)) return -linear_[i].start.value;
    if (!has_after(i)) return linear_[before(i)].end.value;
    const double l0 = run_.lengths[before(i)], l1 = run_.lengths[i], least = std::fmin(l0, l1);
    return least / l0 * linear_[before(i)].end.value - least / l1 * linear_[i].start.value;
}

num::TridiagonalRow Spline::row(std::size_t i, double drag) const {
    if (is_fixed(i)) return {0, 1, 0};
    if (!has_before(i)) {
        return {0, drag - linear_[i].start.by_first, -linear_[i].start.by_second};
    }
    if (!has_after(i)) {
        return {linear_[i - 1].end.by_first, drag + linear_[i - 1].end.by_second, 0};
    }
    const Linear &a = linear_[before(i)], &b = linear_[i];
    const double l0 = run_.lengths[before(i)], l1 = run_.lengths[i], least = std::fmin(l0, l1);
    return {least / l0 * a.end.by_first,
            drag + least / l0 * a.end.by_second - least / l1 * b.start.by_first,
            -least / l1 * b.start.by_second};
}

void Spline::find_change(double drag) {
    for (std::size_t i = 0; i < points_; ++i) change_[i] = is_fixed(i) ? 0 : -jump(i);
    const std::array<double*, 1> columns{change_.data()};
    const auto rows = [&](std::size_t i) { return row(i, drag); };
    if (run_.closed) {
        num::solve_cyclic(points_, rows, columns, shares_);
    } else {
        num::solve_tridiagonal(points_, rows, columns, shares_);
    }
    double most = 0;
    for (double& x : change_) {
        if (!std::isfinite(x)) x = 0;
        most = std::fmax(most, std::fabs(x));
    }
    if (most > longest_step) {
        for (double& x : change_) x *= longest_step / most;
    }
}

State Spline::moved(const State& state) const {
    State result = state;
    for (std::size_t i = 0; i < points_; ++i) result.angles[i] += change_[i];
    for (std::size_t i = 0; i < spans_; ++i) {
        const EndCurvature &s = linear_[i].start_bend, &e = linear_[i].end_bend;
        const double first = change_[i], second = change_[next(i)];
        result.bends[i].start += s.value + s.by_first * first + s.by_second * second;
        result.bends[i].end += e.value + e.by_first * first + e.by_second * second;
    }
    return result;
}

/// Plain Newton steps for tangents and bends together, as long as the merit falls; false unless
/// they end well, with arcs that are no loops.
bool Spline::newton(State& state) {
    for (int i = 0; i < most_newton_steps && state.merit > met_sq; ++i) {
        ++steps_;
        find_change(0);
        State trial = moved(state);
        linearise(trial);
        if (!(trial.merit < state.merit)) return false;
        state = std::move(trial);
    }
    return state.merit <= met_sq && has_no_loops(state);
}

bool Spline::has_no_loops(const State& state) const {
    for (std::size_t i = 0; i < spans_; ++i) {
        const double most = std::fmax(std::fabs(angle0(i, state)), std::fabs(angle1(i, state)));
        if (most > loop_angle || linear_[i].reach < loop_reach) return false;
    }
    return true;
}

Interval Spline::bounds(std::size_t i) const {
    Interval within{-hopeless, hopeless};
    if (has_before(i)) {
        const double chord = ends_[before(i)];
        within = {chord - widest_angle, chord + widest_angle};
    }
    if (has_after(i)) {
        within = {std::fmax(within.lo, starts_[i] - widest_angle),
                  std::fmin(within.hi, starts_[i] + widest_angle)};
    }
    return within;
}

/// Cuts the change where it leaves the bounds, and holds those tangents.
void Spline::hold_at_bounds(const State& state) {
    for (std::size_t i = 0; i < points_; ++i) {
        if (is_fixed(i)) continue;
        const Interval within = bounds(i);
        const double wanted = state.angles[i] + change_[i];
        if (within.contains(wanted)) continue;
        change_[i] = within.clamp(wanted) - state.angles[i];
        held_[i] = true;
    }
}

/// Lets go of the tangents that the jumps pull back inside; whether there are any.
bool Spline::release(const State& state) {
    bool any = false;
    for (std::size_t i = 0; i < points_; ++i) {
        if (!held_[i]) continue;
        const bool at_top = state.angles[i] > bounds(i).middle();
        if (at_top ? jump(i) > 0 : jump(i) < 0) {
            held_[i] = false;
            any = true;
        }
    }
    return any;
}

/// The tangents give way to the jumps like springs in honey, the drag being less the smaller the
/// jumps are: pseudo-transient continuation [KelleyKeyes1998]. Ends in Newton steps.
bool Spline::relax(State& state) {
    settle_all(state);
    linearise(state);
    State best = state;
    double drag = 10;
    int releases = 0;
    for (int i = 0; i < most_relaxing_steps && drag < 1e6; ++i) {
        if (state.merit <= met_sq) {
            if (releases++ == 3 || !release(state)) return true;
            linearise(state);
            drag = 1;
        }
        ++steps_;
        find_change(drag);
        hold_at_bounds(state);
        State trial = moved(state);
        const bool all = settle_all(trial);
        if (all) linearise(trial);
        if (!all || trial.merit >= hopeless) {
            drag *= 4;
            linearise(state);
            continue;
        }
        drag *= std::fmin(2, std::fmax(0.1, std::sqrt(trial.merit / state.merit)));
        state = std::move(trial);
        if (state.merit < best.merit) best = state;
    }
    if (!(state.merit <= best.merit)) state = std::move(best);
    linearise(state);
    return state.merit <= met_sq;
}

SplineChain Spline::solve() {
    State state = start();
    const State begin = state;
    linearise(state);
    if (newton(state)) return chain(std::move(state), true);
    state = begin;
    const bool converged = relax(state);
    return chain(std::move(state), converged);
}

SplineChain Spline::chain(State state, bool converged) {
    SplineChain result;
    result.converged = converged;
    result.steps = steps_;
    for (std::size_t i = 0; i < spans_; ++i) {
        const Bends bends = state.bends[i];
        const double length = run_.lengths[i] / linear_[i].reach;
        const double alpha = span_alpha(alpha_, bends);
        result.other_alphas += alpha != alpha_;
        result.angles.push_back(run_.directions[i] + angle0(i, state));
        result.segments.push_back({alpha, length, bends.start / length, bends.end / length});
    }
    for (std::size_t i = 0; i < points_; ++i) {
        if (!is_fixed(i)) result.jump = std::fmax(result.jump, std::fabs(jump(i)));
        result.held += held_[i] != 0;
    }
    return result;
}

}  // namespace

SplineChain log_aesthetic_spline(const SplineRun& run, double alpha) {
    return Spline(run, alpha).solve();
}

}  // namespace batten::spiral
