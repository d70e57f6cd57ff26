#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "make/pseudo/segment/minima.hpp"
#include "make/pseudo/tables/charts.hpp"
#include "patch_builder.hpp"

namespace batten::pseudo {

/// The least segments in one chart. Outputs: r0, r1, L, packed J.
class SegmentProblem {
public:
    struct Solution {
        PseudoSegment segment;
        double energy = 0;
        bool is_converged = true;
        patches::Outputs outputs{};
    };

    explicit SegmentProblem(Chart chart) : chart_(chart) {}

    patches::Shape shape() const {
        const int n = chart_ == Chart::strip ? 10 : 12;
        return {n, n, 4};
    }
    patches::Box box() const { return box_of(chart_); }
    int x_levels() const { return chart_ == Chart::strip ? 7 : 8; }
    int y_levels() const { return 8; }
    /// Half of what is promised for J.
    double energy_tolerance() const { return 5e-13; }

    bool concerns(double x, double y) const {
        const AnglePair a = angles_at({chart_, x, y});
        const double apart = std::hypot(std::numbers::pi - a.theta0, a.theta1);
        return a.theta0 > 0 && chart_point(a).chart == chart_ && apart > 0.5 * least_distance;
    }
    Solution least(double x, double y) const {
        const AnglePair a = angles_at({chart_, x, y});
        return solution(x, y, least_minimum(a.theta0, a.theta1));
    }
    Solution follow(double x, double y, const Solution& start) const {
        const AnglePair a = angles_at({chart_, x, y});
        return solution(
            x, y, minimum_near({a.theta0, a.theta1, start.segment.r0, start.segment.r1}));
    }
    Solution extrapolated(const Solution& a, const Solution& b, double w) const {
        Solution s = a;
        s.segment.r0 *= std::pow(a.segment.r0 / b.segment.r0, w);
        s.segment.r1 *= std::pow(a.segment.r1 / b.segment.r1, w);
        return s;
    }
    double energy(double x, double y, const patches::Outputs& o) const {
        const ChartPoint p{chart_, x, y};
        return unpacked_energy(p, angles_at(p), o[3]);
    }
    bool agrees(double x, double y, const patches::Outputs& o, const Solution& exact) const;
    patches::Outputs units(const patches::Rectangle& r,
                           const std::vector<patches::Outputs>& values) const;

private:
    Solution solution(double x, double y, const Minimum& m) const {
        const ChartPoint p{chart_, x, y};
        return {m.segment,
                m.pseudo_energy,
                m.is_converged,
                {m.segment.r0, m.segment.r1, m.length,
                 packed_energy(p, angles_at(p), m.pseudo_energy)}};
    }

    Chart chart_;
};

/// About a third of what is promised: r 1e-8, L 1e-9, J 1e-12. Three exceptions: near (pi, 0),
/// (pi, pi) and (pi, -pi) J to 1e-9; short arcs, where J hardly depends on r, are asked for J and L
/// alone; and in the strip r need not be better than J can tell.
inline bool SegmentProblem::agrees(double x, double y, const patches::Outputs& o,
                                   const Solution& exact) const {
    constexpr double degree = std::numbers::pi / 180;
    const AnglePair a = angles_at({chart_, x, y});
    const double energy_error = std::fabs(energy(x, y, o) / exact.energy - 1);
    const double length_error = std::fabs(o[2] - exact.outputs[2]);
    const double r_error = std::max(std::fabs(o[0] - exact.outputs[0]),
                                    std::fabs(o[1] - exact.outputs[1]));
    const double rest0 = std::numbers::pi - a.theta0, size1 = std::fabs(a.theta1);
    const double apart = std::min(std::hypot(rest0, size1),
                                  std::hypot(rest0, std::numbers::pi - size1));
    if (apart < 2 * degree) return energy_error < 3e-10 && length_error < 1e-6 && r_error < 1e-6;
    if (energy_error > energy_tolerance() || length_error > 4e-10) return false;
    if (r_error < 4e-9) return true;
    const bool is_short_arc = a.theta0 < 3 * degree && std::fabs(a.theta0 + a.theta1) < 3 * degree;
    if (is_short_arc) return r_error < 0.05 && length_error < 1e-10 && energy_error < 2e-13;
    const bool is_told_apart = energy_error > 4e-15 || length_error > 1e-11;
    return chart_ == Chart::strip && a.theta0 < 0.2 && !is_told_apart && r_error < 1e-3;
}

inline patches::Outputs SegmentProblem::units(const patches::Rectangle& r,
                                              const std::vector<patches::Outputs>& values) const {
    const auto power_below = [](double x) { return std::exp2(std::floor(std::log2(x))); };
    double least = std::fabs(values[0][3]);
    for (const patches::Outputs& o : values) least = std::min(least, std::fabs(o[3]));
    double unit = 0x1p-47 * least;
    if (chart_ == Chart::near || chart_ == Chart::strip) unit = 0x1p-46 / (r.box.x.hi * r.box.x.hi);
    if (chart_ == Chart::far) unit = 0x1p-46 / (r.box.y.hi * r.box.y.hi);
    return {0x1p-34, 0x1p-34, 0x1p-37, power_below(unit)};
}

}  // namespace batten::pseudo
