#include "batten/measure/surface_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "batten/measure/graph_bend.hpp"
#include "num/gauss.hpp"
#include "shape/surface/sheet.hpp"

namespace batten {
namespace {

using surfaces::Sheet;

constexpr int gauss_nodes = 8;
constexpr int most_quarterings = 5;
constexpr int height_lattice = 5;      // places a patch and direction
constexpr int curvature_lattice = 13;  // quotients, with peaks where slopes vanish
constexpr double finest_step = 1e-9;   // of a patch
constexpr int most_rounds = 400;       // of a climb along a ridge

/// A part of one knot interval: shares of its width, ordinates.
struct Part {
    std::size_t interval = 0;
    Interval share{0, 1}, y;
};

double area_by_rule(const Sheet& sheet, const Part& part) {
    const num::GaussRule rule = num::gauss_legendre(gauss_nodes);
    return num::integrate(
        [&](double y) {
            const std::vector<double> knots = sheet.knots(y);
            const Interval x{Sheet::place({part.interval, part.share.lo}, knots),
                             Sheet::place({part.interval, part.share.hi}, knots)};
            if (!(x.lo < x.hi)) return 0.0;
            return num::integrate(
                [&](double at) {
                    const HeightJet jet = sheet.jet_in(part.interval, at, y);
                    return std::hypot(1.0, jet.x, jet.y);
                },
                x, rule);
        },
        part.y, rule);
}

/// Adds the area over `part`, once `whole` by one rule, to `sum`.
void add_area(const Sheet& sheet, const Part& part, double whole, double allowed, int halvings,
              Measured& sum) {
    const double u = part.share.middle(), y = part.y.middle();
    Part quarters[4];
    for (std::size_t k = 0; k < 4; ++k) {
        quarters[k] = {part.interval,
                       k < 2 ? Interval{part.share.lo, u} : Interval{u, part.share.hi},
                       k % 2 == 0 ? Interval{part.y.lo, y} : Interval{y, part.y.hi}};
    }
    double parts[4], total = 0;
    for (int k = 0; k < 4; ++k) total += parts[k] = area_by_rule(sheet, quarters[k]);
    const double error = std::fabs(total - whole);
    if (!(error > allowed) || halvings == most_quarterings) {
        sum.value += total;
        sum.error += error;
        return;
    }
    for (int k = 0; k < 4; ++k) {
        add_area(sheet, quarters[k], parts[k], allowed / 4, halvings + 1, sum);
    }
}

template <class Work>
void on_patches(const Sheet& sheet, Work work) {
    const std::vector<double> strips = sheet.strips();
    for (const std::size_t interval : sheet.intervals()) {
        for (std::size_t j = 0; j + 1 < strips.size(); ++j) {
            work(Part{interval, {0, 1}, {strips[j], strips[j + 1]}});
        }
    }
}

/// What the middle of a patch measures each way.
std::array<double, 2> sides_of(const Sheet& sheet, const Part& patch) {
    const std::vector<double> knots = sheet.knots(patch.y.middle());
    return {knots[patch.interval + 1] - knots[patch.interval], patch.y.length()};
}

/// Steps across and along knot lines to better neighbours, doubled after each and halved where there
/// is none.
template <class Value>
SurfacePlace climbed(const Sheet& sheet, SurfacePlace at, const std::array<double, 2>& sides,
                     double widest, double sign, Value value) {
    const Rectangle domain = sheet.domain();
    double step = widest;
    for (int round = 0; round < most_rounds && step > finest_step; ++round) {
        SurfacePlace best = at;
        for (const auto [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const double y = domain.y.clamp(at.y + dy * step * sides[1]);
            const double x =
                domain.x.clamp(sheet.along(at.x, at.y, y) + dx * step * sides[0]);
            const double height = value(KnotCell::found, x, y);
            if (sign * height > sign * best.value) best = {height, x, y};
        }
        const bool is_still = best.x == at.x && best.y == at.y;
        step = is_still ? step / 2 : std::min(2 * step, widest);
        at = best;
    }
    return at;
}

/// What a lattice sees of one patch.
template <int lattice>
struct PatchLattice {
    SurfacePlace nodes[lattice * lattice];
    std::array<double, 2> sides{};

    double best(double sign) const {
        double best = -std::numeric_limits<double>::infinity();
        for (const SurfacePlace& node : nodes) best = std::max(best, sign * node.value);
        return best;
    }
    /// Whether no node beside is better.
    bool is_local_best(int k, double sign) const {
        const int i = k / lattice, j = k % lattice;
        for (int di = -1; di <= 1; ++di) {
            for (int dj = -1; dj <= 1; ++dj) {
                const int r = i + di, s = j + dj;
                if (r < 0 || r >= lattice || s < 0 || s >= lattice) continue;
                if (sign * nodes[r * lattice + s].value > sign * nodes[k].value) return false;
            }
        }
        return true;
    }
};

template <int lattice, class Value>
std::vector<PatchLattice<lattice>> lattices_of(const Sheet& sheet, Value value) {
    std::vector<PatchLattice<lattice>> lattices;
    on_patches(sheet, [&](const Part& patch) {
        PatchLattice<lattice> seen;
        seen.sides = sides_of(sheet, patch);
        for (int k = 0; k < lattice * lattice; ++k) {
            const double share = static_cast<double>(k / lattice) / (lattice - 1);
            const double y = patch.y.lo + patch.y.length() * (k % lattice) / (lattice - 1);
            const double x = Sheet::place({patch.interval, share}, sheet.knots(y));
            seen.nodes[k] = {value(patch.interval, x, y), x, y};
        }
        lattices.push_back(seen);
    });
    return lattices;
}

/// The extreme by climbs from the local bests of all patches, the best first; those are left out
/// that would have to rise by half of what their patch spans.
template <int lattice, class Value>
SurfacePlace extreme_of(const Sheet& sheet, const std::vector<PatchLattice<lattice>>& lattices,
                        double sign, Value value) {
    std::vector<std::size_t> order(lattices.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return lattices[a].best(sign) > lattices[b].best(sign);
    });
    std::optional<SurfacePlace> best;
    for (const std::size_t p : order) {
        const PatchLattice<lattice>& patch = lattices[p];
        const double span = patch.best(sign) + patch.best(-sign);
        for (int k = 0; k < lattice * lattice; ++k) {
            const SurfacePlace& node = patch.nodes[k];
            const bool may_win =
                !best || sign * node.value + 0.5 * span > sign * best->value;
            if (!may_win || !patch.is_local_best(k, sign)) continue;
            const SurfacePlace top = climbed(sheet, node, patch.sides, 1.0 / lattice, sign, value);
            if (!best || sign * top.value > sign * best->value) best = top;
        }
    }
    return *best;
}

template <int lattice, class Value>
SurfaceRange range_of(const Sheet& sheet, Value value) {
    const auto lattices = lattices_of<lattice>(sheet, value);
    SurfaceRange range{extreme_of(sheet, lattices, -1, value),
                       extreme_of(sheet, lattices, 1, value)};
    if (sheet.is_transposed()) {
        for (SurfacePlace* const place : {&range.least, &range.largest}) {
            std::swap(place->x, place->y);
        }
    }
    return range;
}

double area_of(const Rectangle& part) { return part.x.length() * part.y.length(); }

}  // namespace

Measured surface_area(const Surface& surface, Tolerance tolerance) {
    const Sheet sheet(surface);
    const double plane = area_of(sheet.domain()), allowed = tolerance.in_units(plane);
    Measured sum;
    on_patches(sheet, [&](const Part& patch) {
        const std::array<double, 2> sides = sides_of(sheet, patch);
        const double share = sides[0] * sides[1] / plane;
        add_area(sheet, patch, area_by_rule(sheet, patch), allowed * share, 0, sum);
    });
    return sum;
}

SurfaceReport measure_surface(const Surface& surface, Tolerance tolerance) {
    SurfaceReport report;
    const Sheet sheet(surface);
    const Rectangle d = domain_of(surface);
    report.domain = {d.x.lo, d.x.hi, d.y.lo, d.y.hi};
    report.integral = integral(surface, d);
    const Measured area = surface_area(surface, tolerance);
    if (std::isfinite(area.value) && std::isfinite(area.error)) {
        report.area = area.value;
        report.area_error = area.error;
        if (area.error > tolerance.in_units(area_of(d))) report.status = Status::not_met;
    } else {
        report.notes.push_back("the slopes are too large for an area");
    }
    report.height = range_of<height_lattice>(sheet, [&](std::size_t i, double x, double y) {
        return sheet.value_in(i, x, y);
    });
    report.gaussian_curvature = range_of<curvature_lattice>(sheet, [&](std::size_t i, double x, double y) {
        return graph_bend(sheet.jet_in(i, x, y)).gaussian;
    });
    report.mean_curvature = range_of<curvature_lattice>(sheet, [&](std::size_t i, double x, double y) {
        return graph_bend(sheet.jet_in(i, x, y)).mean;
    });
    return report;
}

}  // namespace batten
