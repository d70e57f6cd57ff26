#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "make/sample/walk.hpp"

namespace batten {
namespace {

/// When the law has come to `share` of the way, not before `from`: of all such times the first.
double time_at_share(const MotionLaw& law, double share, double from) {
    constexpr int halvings = 50;
    Interval around{from, 1};
    for (int i = 0; i < halvings; ++i) {
        const double middle = around.middle();
        (law.at(middle).share < share ? around.lo : around.hi) = middle;
    }
    return around.hi;
}

}  // namespace

std::vector<double> piece_speeds(const Curve& curve, const SampleOptions& options) {
    sampling::require_ranges(options);
    if (options.law == Law::chord) {
        throw Error("sample.options", "law", "chord", "this law tells places and no speeds");
    }
    const ArcLengthMap map(curve);
    const sampling::ChosenLaw chosen = sampling::choose_law(curve, map, options);
    const double duration = options.duration.value_or(chosen.duration.value_or(1));
    std::vector<double> speeds;
    double tau = 0, way = 0;
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const bool is_last = i + 1 == curve.pieces();
        const double next_way = is_last ? map.length() : map.s_of(curve.piece(i).hi);
        const double next =
            is_last ? 1 : time_at_share(chosen.law, next_way / map.length(), tau);
        if (!(next > tau)) {
            throw Error("motion.no-time", "piece " + std::to_string(i), "none",
                        "the law must spend time on every piece of the curve");
        }
        speeds.push_back((next_way - way) / ((next - tau) * duration));
        tau = next;
        way = next_way;
    }
    return speeds;
}

}  // namespace batten
