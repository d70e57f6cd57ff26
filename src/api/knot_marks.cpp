#include "api/knot_marks.hpp"

#include <algorithm>
#include <cmath>

namespace batten::api {
namespace {

// Shares of the height of what is shown between the marks.
constexpr double mark_length = 0.04;
constexpr double mark_air = 0.035;  // on both sides of the marks
constexpr double plain_air = 0.06;  // where there are none
constexpr double side_by_side = 0.009;  // of the domain: the marks of a double knot

/// How often the knot at `x` stands in the knot vector.
std::size_t multiplicity(const SplineFunction& spline, double x) {
    const std::span<const double> knots = spline.knots();
    const auto [first, last] = std::equal_range(knots.begin(), knots.end(), x);
    return std::max<std::size_t>(static_cast<std::size_t>(last - first), 1);
}

}  // namespace

void add_knot_marks(Panel& panel, const SplineFunction& spline, Interval content,
                    KnotEdges edges) {
    const double length = content.length();
    const double mark = mark_length * length, air = mark_air * length;
    const double step = side_by_side * spline.domain().length();
    PolylineLayer marks{{}, "knots", {Tone::blue, Dash::solid, 1.3}};
    const std::span<const double> breaks = spline.breaks();
    for (std::size_t i = 0; i < breaks.size(); ++i) {
        const bool is_end = i == 0 || i + 1 == breaks.size();
        const std::size_t times = is_end ? 1 : multiplicity(spline, breaks[i]);
        for (std::size_t k = 0; k < times; ++k) {
            const double off = static_cast<double>(k) - 0.5 * static_cast<double>(times - 1);
            const double x = breaks[i] + off * step;
            const double foot = content.lo - air - mark, top = content.hi + air;
            marks.runs.emplace_back(std::vector<double>{x, foot, x, foot + mark}, 2);
            if (edges == KnotEdges::bottom) continue;
            marks.runs.emplace_back(std::vector<double>{x, top, x, top + mark}, 2);
        }
    }
    panel.add(std::move(marks));
    const double above = edges == KnotEdges::both ? mark + 2 * air : plain_air * length;
    panel.y_range = Interval{content.lo - mark - 2 * air, content.hi + above};
}

Interval widened(Interval core, Interval more, double share) {
    const double reach = share * core.length();
    Interval all{std::min(core.lo, more.lo), std::max(core.hi, more.hi)};
    if (reach > 0) {
        all = {std::max(all.lo, core.lo - reach), std::min(all.hi, core.hi + reach)};
    }
    // A height of nothing, or of less than can be told apart, is given one.
    const double size = std::max(std::fabs(all.lo), std::fabs(all.hi));
    if (all.length() > 1e-9 * size) return all;
    const double half = size > 0 ? 0.1 * size : 1;
    return {all.lo - half, all.hi + half};
}

Interval extent_of(std::span<const double> values) {
    const auto [lo, hi] = std::minmax_element(values.begin(), values.end());
    return {*lo, *hi};
}

}  // namespace batten::api
