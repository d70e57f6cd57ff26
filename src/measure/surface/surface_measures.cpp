#include "batten/measure/surface_measures.hpp"

#include <cmath>

#include "batten/measure/graph_bend.hpp"
#include "num/gauss.hpp"

namespace batten {
namespace {

constexpr int gauss_nodes = 8;
constexpr int most_quarterings = 5;
constexpr int lattice = 5;             // places a patch and direction
constexpr double finest_step = 1e-9;   // of a patch

double area_by_rule(const SplineSurface& surface, const Rectangle& part) {
    const num::GaussRule rule = num::gauss_legendre(gauss_nodes);
    return num::integrate(
        [&](double x) {
            return num::integrate(
                [&](double y) {
                    return std::hypot(1.0, surface(x, y, {1, 0}), surface(x, y, {0, 1}));
                },
                part.y, rule);
        },
        part.x, rule);
}

/// Adds the area over `part`, once `whole` by one rule, to `sum`.
void add_area(const SplineSurface& surface, const Rectangle& part, double whole, double allowed,
              int halvings, Measured& sum) {
    const double x = part.x.middle(), y = part.y.middle();
    const Rectangle quarters[] = {{{part.x.lo, x}, {part.y.lo, y}}, {{part.x.lo, x}, {y, part.y.hi}},
                                  {{x, part.x.hi}, {part.y.lo, y}}, {{x, part.x.hi}, {y, part.y.hi}}};
    double parts[4], total = 0;
    for (int k = 0; k < 4; ++k) total += parts[k] = area_by_rule(surface, quarters[k]);
    const double error = std::fabs(total - whole);
    if (!(error > allowed) || halvings == most_quarterings) {
        sum.value += total;
        sum.error += error;
        return;
    }
    for (int k = 0; k < 4; ++k) {
        add_area(surface, quarters[k], parts[k], allowed / 4, halvings + 1, sum);
    }
}

template <class Work>
void on_patches(const SplineSurface& surface, Work work) {
    const std::span<const double> x = surface.x_basis().breaks(), y = surface.y_basis().breaks();
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        for (std::size_t j = 0; j + 1 < y.size(); ++j) {
            work(Rectangle{{x[i], x[i + 1]}, {y[j], y[j + 1]}});
        }
    }
}

/// Steps to better neighbours, halved where there is none.
template <class Value>
SurfacePlace climbed(const SplineSurface& surface, SurfacePlace at, const Rectangle& patch,
                     double sign, Value value) {
    const Rectangle domain = surface.domain();
    double step = 1.0 / lattice;
    while (step > finest_step) {
        SurfacePlace best = at;
        for (const auto [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const double x = domain.x.clamp(at.x + dx * step * patch.x.length());
            const double y = domain.y.clamp(at.y + dy * step * patch.y.length());
            const double height = value(x, y);
            if (sign * height > sign * best.value) best = {height, x, y};
        }
        if (best.x == at.x && best.y == at.y) step /= 2;
        at = best;
    }
    return at;
}

template <class Value>
SurfaceRange range_of(const SplineSurface& surface, Value value) {
    SurfaceRange range;
    Rectangle low_patch, high_patch;
    bool is_first = true;
    on_patches(surface, [&](const Rectangle& patch) {
        for (int k = 0; k < lattice * lattice; ++k) {
            const double x = patch.x.lo + patch.x.length() * (k / lattice) / (lattice - 1);
            const double y = patch.y.lo + patch.y.length() * (k % lattice) / (lattice - 1);
            const SurfacePlace place{value(x, y), x, y};
            if (is_first || place.value < range.least.value) {
                range.least = place;
                low_patch = patch;
            }
            if (is_first || place.value > range.largest.value) {
                range.largest = place;
                high_patch = patch;
            }
            is_first = false;
        }
    });
    range.least = climbed(surface, range.least, low_patch, -1, value);
    range.largest = climbed(surface, range.largest, high_patch, 1, value);
    return range;
}

}  // namespace

Measured surface_area(const SplineSurface& surface, Tolerance tolerance) {
    const Rectangle domain = surface.domain();
    const double plane = domain.x.length() * domain.y.length();
    const double allowed = tolerance.in_units(plane);
    Measured sum;
    on_patches(surface, [&](const Rectangle& patch) {
        const double share = patch.x.length() * patch.y.length() / plane;
        add_area(surface, patch, area_by_rule(surface, patch), allowed * share, 0, sum);
    });
    return sum;
}

SurfaceReport measure_surface(const SplineSurface& surface, Tolerance tolerance) {
    SurfaceReport report;
    const Rectangle d = surface.domain();
    report.domain = {d.x.lo, d.x.hi, d.y.lo, d.y.hi};
    report.integral = integral(surface);
    const Measured area = surface_area(surface, tolerance);
    if (std::isfinite(area.value) && std::isfinite(area.error)) {
        report.area = area.value;
        report.area_error = area.error;
        const double allowed = tolerance.in_units(d.x.length() * d.y.length());
        if (area.error > allowed) report.status = Status::not_met;
    } else {
        report.notes.push_back("the slopes are too large for an area");
    }
    report.height = range_of(surface, [&](double x, double y) { return surface(x, y); });
    report.gaussian_curvature = range_of(
        surface, [&](double x, double y) { return graph_bend(surface, x, y).gaussian; });
    report.mean_curvature = range_of(
        surface, [&](double x, double y) { return graph_bend(surface, x, y).mean; });
    return report;
}

}  // namespace batten
