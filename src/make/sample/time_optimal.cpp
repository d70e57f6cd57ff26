#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/motion.hpp"
#include "make/sample/speed_limit.hpp"
#include "num/roots.hpp"
#include "num/sum.hpp"

namespace batten {
namespace {

using sampling::SpeedLimit;

enum class Phase { speeding_up, along_limit, slowing_down };

/// A stretch of one phase.
struct Leg {
    Phase phase;
    double s_lo, s_hi;
    double v_lo, v_hi;
    double inside;  ///< a parameter within the limit's place
    double start = 0, time = 0;
};

/// v^2 at the places: the largest that is nowhere above the limit nor steeper than allowed.
std::vector<double> squares(const std::vector<SpeedLimit::Place>& places, double tangential) {
    std::vector<double> q;
    for (const SpeedLimit::Place& place : places) q.push_back(place.q);
    q.front() = q.back() = 0;
    for (std::size_t i = 1; i < q.size(); ++i) {
        q[i] = std::fmin(q[i], q[i - 1] + 2 * tangential * (places[i].s - places[i - 1].s));
    }
    for (std::size_t i = q.size() - 1; i-- > 0;) {
        q[i] = std::fmin(q[i], q[i + 1] + 2 * tangential * (places[i + 1].s - places[i].s));
    }
    return q;
}

/// The fastest walk over one interval between places, v^2 being given at both.
class Walk {
public:
    Walk(const SpeedLimit& limit, const SpeedLimit::Place& from, const SpeedLimit::Place& to,
         double q_from, double q_to)
        : limit_(limit), from_(from.s), to_(to.s), q_from_(q_from), q_to_(q_to),
          inside_(0.5 * (from.t + to.t)) {}

    void add_legs(std::vector<Leg>& legs) const {
        const double slope = 2 * limit_.tangential();
        const double up_to = leaves_up(), down_from = reaches_down();
        if (up_to < down_from) {
            add(legs, Phase::speeding_up, from_, up_to);
            add(legs, Phase::along_limit, up_to, down_from);
            add(legs, Phase::slowing_down, down_from, to_);
        } else {
            const double meet =
                std::clamp(0.5 * (from_ + to_ + (q_to_ - q_from_) / slope), from_, to_);
            add(legs, Phase::speeding_up, from_, meet);
            add(legs, Phase::slowing_down, meet, to_);
        }
    }

private:
    double up(double s) const { return q_from_ + 2 * limit_.tangential() * (s - from_); }
    double down(double s) const { return q_to_ + 2 * limit_.tangential() * (to_ - s); }
    /// Where speeding up meets the limit, and where slowing down leaves it. The other end is looked
    /// at first: a limit that rises steeply from here on is left at once, and never met.
    double leaves_up() const {
        const auto above = [this](double s) { return up(s) - limit_.at(s, inside_); };
        if (above(to_) <= 0) return to_;
        return above(from_) >= 0 ? from_ : num::find_root(above, {from_, to_}).at;
    }
    double reaches_down() const {
        const auto above = [this](double s) { return down(s) - limit_.at(s, inside_); };
        if (above(from_) <= 0) return from_;
        return above(to_) >= 0 ? to_ : num::find_root(above, {from_, to_}).at;
    }
    void add(std::vector<Leg>& legs, Phase phase, double lo, double hi) const {
        if (!(lo < hi)) return;
        Leg leg{phase, lo, hi, 0, 0, inside_};
        if (phase == Phase::along_limit) {
            leg.v_lo = std::sqrt(limit_.at(lo, inside_));
            leg.v_hi = std::sqrt(limit_.at(hi, inside_));
            leg.time = limit_.time(lo, hi, inside_);
        } else {
            const bool is_up = phase == Phase::speeding_up;
            leg.v_lo = std::sqrt(std::fmax(is_up ? up(lo) : down(lo), 0));
            leg.v_hi = std::sqrt(std::fmax(is_up ? up(hi) : down(hi), 0));
            leg.time = 2 * (hi - lo) / (leg.v_lo + leg.v_hi);
        }
        legs.push_back(leg);
    }

    const SpeedLimit& limit_;
    double from_, to_, q_from_, q_to_, inside_;
};

struct State {
    double s = 0, v = 0;
};

State state_in(const Leg& leg, double time, const SpeedLimit& limit) {
    if (time >= leg.time) return {leg.s_hi, leg.v_hi};
    if (leg.phase == Phase::along_limit) {
        const auto late = [&](double s) { return limit.time(leg.s_lo, s, leg.inside) - time; };
        const double s = num::find_root(late, {leg.s_lo, leg.s_hi}).at;
        return {s, std::sqrt(limit.at(s, leg.inside))};
    }
    const double change = (leg.v_hi - leg.v_lo) / leg.time;
    return {leg.s_lo + time * (leg.v_lo + 0.5 * change * time), leg.v_lo + change * time};
}

void require_limits(const MotionLimits& limits) {
    const auto require = [](const char* name, double value) {
        if (value > 0 && std::isfinite(value)) return;
        throw Error("option.range", name, format_number(value), "must be more than 0 and finite");
    };
    require("max_speed", limits.speed);
    require("max_lateral", limits.lateral);
    require("max_tangential", limits.tangential);
}

}  // namespace

TimedLaw time_optimal_law(const Curve& curve, const ArcLengthMap& map,
                          const MotionLimits& limits) {
    require_limits(limits);
    auto limit = std::make_shared<const SpeedLimit>(curve, map, limits);
    const std::vector<SpeedLimit::Place> places = limit->places();
    const std::vector<double> q = squares(places, limits.tangential);
    auto legs = std::make_shared<std::vector<Leg>>();
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        Walk(*limit, places[i], places[i + 1], q[i], q[i + 1]).add_legs(*legs);
    }
    num::Sum time;
    for (Leg& leg : *legs) {
        leg.start = time.value();
        time.add(leg.time);
    }
    const double duration = time.value(), length = map.length();
    return {MotionLaw([limit, legs, duration, length](double tau) -> MotionState {
                const double now = tau * duration;
                const auto next = std::upper_bound(
                    legs->begin() + 1, legs->end(), now,
                    [](double x, const Leg& leg) { return x < leg.start; });
                const Leg& leg = *(next - 1);
                const State state = state_in(leg, now - leg.start, *limit);
                return {tau >= 1 ? 1 : state.s / length, state.v * duration / length};
            }),
            duration, limit->corners()};
}

}  // namespace batten
