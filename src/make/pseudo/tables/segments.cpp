#include "make/pseudo/tables/segments.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "make/pseudo/segment/descent.hpp"
#include "make/pseudo/segment/kernel.hpp"
#include "make/pseudo/segment/minima.hpp"
#include "make/pseudo/tables/charts.hpp"
#include "make/pseudo/tables/tabulated.hpp"

namespace batten::pseudo {
namespace {

/// Below this J is 0 to double precision whatever r0, r1 are.
constexpr double least_angle = 1e-70;

/// A pair in the quarter domain of the charts, and how it got there.
struct Folded {
    AnglePair angles;
    bool is_swapped;
};

Folded folded(double theta0, double theta1) {
    const bool is_swapped = std::fabs(theta1) > std::fabs(theta0);
    const AnglePair a = is_swapped ? AnglePair{theta1, theta0} : AnglePair{theta0, theta1};
    const bool is_mirrored = a.theta0 < 0;
    return {is_mirrored ? AnglePair{-a.theta0, -a.theta1} : a, is_swapped};
}

TabulatedSegment unfolded(TabulatedSegment s, const Folded& f) {
    // Polynomials for r0 and r1 are rounded apart.
    if (std::fabs(f.angles.theta1) == f.angles.theta0 && std::fabs(s.r0 - s.r1) < 1e-8) {
        s.r0 = s.r1 = 0.5 * (s.r0 + s.r1);
    }
    if (f.is_swapped) std::swap(s.r0, s.r1);
    return s;
}

/// A table for each chart.
class Atlas {
public:
    Atlas() {
        for (std::size_t i = 0; i < chart_count; ++i) {
            const Chart chart = static_cast<Chart>(i);
            tables_.emplace_back(segment_text(chart), box_of(chart));
        }
    }

    /// A place without functions where the tables have nothing.
    patches::Place find(const ChartPoint& p) const { return table(p).find(p.x, p.y); }

    /// The least of a place's functions. Requires: it has some.
    TabulatedSegment least(const patches::Place& place, const ChartPoint& p,
                           const AnglePair& a) const {
        TabulatedSegment least;
        for (int i = 0; i < place.functions; ++i) {
            const patches::Outputs o = table(p).value(place, i);
            const double energy = unpacked_energy(p, a, o[3]);
            if (i == 0 || energy < least.pseudo_energy) least = {o[0], o[1], o[2], energy};
        }
        return least;
    }

private:
    const patches::Table& table(const ChartPoint& p) const {
        return tables_[static_cast<std::size_t>(p.chart)];
    }

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

/// Whether the tables do not go so near to the origin or to a node.
bool is_outside(const ChartPoint& p) {
    if (p.chart >= Chart::node) return p.x < least_distance;
    return p.chart != Chart::wide && (p.chart == Chart::far ? p.y : p.x) < least_angle0;
}

TabulatedSegment found_or_minimised(const AnglePair& a) {
    const ChartPoint p = chart_point(a);
    if (p.chart >= Chart::node && is_outside(p)) return minimised(a);
    const patches::Place place = atlas().find(p);
    return place.functions == 0 ? minimised(a) : atlas().least(place, p, a);
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

/// Where the tables do not go.
TabulatedSegment outside(const AnglePair& a, const ChartPoint& p) {
    if (p.chart >= Chart::node) return minimised(a);
    return a.theta0 < least_angle ? TabulatedSegment{} : scaled_down(a, p);
}

/// A pair and where it is seen.
struct Seen {
    Folded folded;
    ChartPoint point;
};

Seen seen(double theta0, double theta1) {
    const Folded f = folded(theta0, theta1);
    if (f.angles.theta0 < least_angle) return {f, {Chart::near, 0, 0}};
    return {f, chart_point(f.angles)};
}

patches::Place place_of(const Seen& s) {
    const bool is_small = s.folded.angles.theta0 < least_angle0 || is_outside(s.point);
    return is_small ? patches::Place{} : atlas().find(s.point);
}

/// Below this r is better known to the gradient of J, which is in closed form, than to J, from which
/// the tables of the strip are made.
constexpr double most_polished = 0.4;

/// Newton's method on the gradient: one step, up to three where r was not known to 1e-6.
TabulatedSegment polished(TabulatedSegment s, const AnglePair& a) {
    constexpr int most_steps = 3;
    constexpr double large = 0.01, small = 1e-6;
    for (int i = 0; i < most_steps; ++i) {
        const Expansion<2> j = expand_magnitudes({a.theta0, a.theta1, s.r0, s.r1});
        const auto step = shifted_newton_step<2>({j.value, j.gradient, j.hessian}, 0);
        if (!step) break;
        const double size = std::fmax(std::fabs((*step)[0]), std::fabs((*step)[1]));
        if (!(size < large)) break;
        s.r0 *= std::exp((*step)[0]);
        s.r1 *= std::exp((*step)[1]);
        if (size < small) break;
    }
    return s;
}

TabulatedSegment worked_out(const Seen& s, const patches::Place& place) {
    const AnglePair& a = s.folded.angles;
    if (place.functions > 0) {
        const TabulatedSegment least = atlas().least(place, s.point, a);
        const bool is_flat = s.point.chart == Chart::strip && a.theta0 < most_polished;
        return unfolded(is_flat ? polished(least, a) : least, s.folded);
    }
    const bool is_small = a.theta0 < least_angle0 || is_outside(s.point);
    return unfolded(is_small ? outside(a, s.point) : minimised(a), s.folded);
}

}  // namespace

TabulatedSegment tabulated_segment(double theta0, double theta1) {
    const Seen s = seen(theta0, theta1);
    return worked_out(s, place_of(s));
}

void tabulate_segments(TabulatedBatch& batch, std::size_t count) {
    Seen points[TabulatedBatch::most];
    patches::Place places[TabulatedBatch::most];
    for (std::size_t i = 0; i < count; ++i) points[i] = seen(batch.theta0[i], batch.theta1[i]);
    for (std::size_t i = 0; i < count; ++i) places[i] = place_of(points[i]);
    for (std::size_t i = 0; i < count; ++i) {
        batch.segments[i] = worked_out(points[i], places[i]);
    }
}

PseudoSegment least_segment(double theta0, double theta1, Source source) {
    if (source == Source::minimiser) return least_pseudo_segment(theta0, theta1);
    const TabulatedSegment s = tabulated_segment(theta0, theta1);
    return {theta0, theta1, s.r0, s.r1};
}

}  // namespace batten::pseudo
