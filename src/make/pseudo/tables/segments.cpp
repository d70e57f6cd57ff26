#include "make/pseudo/tables/segments.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "make/pseudo/segment/minima.hpp"
#include "make/pseudo/tables/charts.hpp"
#include "make/pseudo/tables/tabulated.hpp"

namespace batten::pseudo {
namespace {

/// Below this J is 0 to double precision whatever r0, r1 are.
constexpr double least_angle = 1e-70;

/// A table for each chart.
class Atlas {
public:
    Atlas() {
        for (std::size_t i = 0; i < chart_count; ++i) {
            const Chart chart = static_cast<Chart>(i);
            tables_.emplace_back(segment_text(chart), box_of(chart));
        }
    }

    /// Nothing where the tables have nothing.
    std::optional<TabulatedSegment> find(const ChartPoint& p, const AnglePair& a) const {
        const patches::Table& table = tables_[static_cast<std::size_t>(p.chart)];
        const patches::Place place = table.find(p.x, p.y);
        if (place.functions == 0) return std::nullopt;
        TabulatedSegment least;
        for (int i = 0; i < place.functions; ++i) {
            const patches::Outputs o = table.value(place, i);
            const double energy = unpacked_energy(p, a, o[3]);
            if (i == 0 || energy < least.pseudo_energy) least = {o[0], o[1], o[2], energy};
        }
        return least;
    }

private:
    std::vector<patches::Table> tables_;
};

const Atlas& atlas() {
    static const Atlas tables;
    return tables;
}

TabulatedSegment minimised(const AnglePair& a) {
    const Minimum m = least_minimum(a.theta0, a.theta1);
    return {m.segment.r0, m.segment.r1, m.length, m.pseudo_energy};
}

bool is_small(const ChartPoint& p) {
    return p.chart == Chart::far ? p.y < least_angle0 : p.x < least_angle0;
}

TabulatedSegment found_or_minimised(const AnglePair& a) {
    const ChartPoint p = chart_point(a);
    if (p.chart >= Chart::node && p.x < least_distance) return minimised(a);
    const auto found = atlas().find(p, a);
    return found ? *found : minimised(a);
}

/// From larger angles of the same ratio s = theta1 / theta0:
///     J = theta0^2 (4 (1 + s + s^2) + q(s) theta0^2 + c(s) theta0^4 + O(theta0^6)),
///     L = 1 + (2 - s + 2 s^2) / 30 theta0^2 + d(s) theta0^4 + O(theta0^6),
/// with c and d from the tables; r from larger angles of the same bend (near) or 1 / bend (far),
/// where r0 + r1 - 2 goes as theta0^2 and r0 - r1 as theta0.
TabulatedSegment scaled_down(const AnglePair& a, const ChartPoint& p) {
    const double s = a.theta1 / a.theta0, t = least_angle0;
    const double small = a.theta0 * a.theta0, large = t * t;
    const double second = 4 * (1 + s + s * s);
    const double fourth =
        2.0 / 105 * (8 + s * (4 + s * (27 + s * (4 + 8 * s))));
    const double bulge = (2 - s + 2 * s * s) / 30;
    const TabulatedSegment same_ratio = found_or_minimised({t, s * t});
    const double sixth = ((same_ratio.pseudo_energy / large - second) / large - fourth) / large;
    const double third = ((same_ratio.length - 1) / large - bulge) / large;

    ChartPoint q = p;
    double& scale = p.chart == Chart::far ? q.y : q.x;
    const double shrink = scale / t;
    scale = t;
    const AnglePair same_bend = p.chart == Chart::far
                                    ? angles_at(q)
                                    : AnglePair{t, t * (t * (s + 1) / a.theta0 - 1)};
    const TabulatedSegment model = found_or_minimised(same_bend);
    const double sum = (model.r0 - 1 + (model.r1 - 1)) * shrink * shrink;
    const double difference = (model.r0 - model.r1) * shrink;
    return {1 + 0.5 * (sum + difference), 1 + 0.5 * (sum - difference),
            1 + small * (bulge + small * third),
            small * (second + small * (fourth + small * sixth))};
}

TabulatedSegment in_quarter(const AnglePair& a) {
    if (a.theta0 < least_angle) return {};
    const ChartPoint p = chart_point(a);
    const bool is_near_origin = p.chart == Chart::near || p.chart == Chart::far ||
                                p.chart == Chart::strip;
    if (a.theta0 < least_angle0 || (is_near_origin && is_small(p))) return scaled_down(a, p);
    return found_or_minimised(a);
}

}  // namespace

TabulatedSegment tabulated_segment(double theta0, double theta1) {
    AnglePair a{theta0, theta1};
    const bool is_swapped = std::fabs(theta1) > std::fabs(theta0);
    if (is_swapped) std::swap(a.theta0, a.theta1);
    if (a.theta0 < 0) a = {-a.theta0, -a.theta1};
    TabulatedSegment s = in_quarter(a);
    // Polynomials for r0 and r1 are rounded apart.
    if (std::fabs(a.theta1) == a.theta0 && std::fabs(s.r0 - s.r1) < 1e-8) {
        s.r0 = s.r1 = 0.5 * (s.r0 + s.r1);
    }
    if (is_swapped) std::swap(s.r0, s.r1);
    return s;
}

PseudoSegment least_segment(double theta0, double theta1, Source source) {
    if (source == Source::minimiser) return least_pseudo_segment(theta0, theta1);
    const TabulatedSegment s = tabulated_segment(theta0, theta1);
    return {theta0, theta1, s.r0, s.r1};
}

}  // namespace batten::pseudo
