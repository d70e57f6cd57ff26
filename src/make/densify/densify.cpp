#include "batten/make/densify.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/densify/cell_curve.hpp"
#include "make/densify/cell_run.hpp"
#include "make/densify/chord_error.hpp"

namespace batten {
namespace {

using namespace lagrange;

constexpr int usual_between = 3;  // [Nakajima]: s = 1/4, 1/2, 3/4
constexpr double most_points = 1e8;

std::size_t fixed_between(const DensifyOptions& options) {
    const int between = options.between.value_or(usual_between);
    if (between < 0) {
        throw Error("option.range", "between", std::to_string(between), "must not be negative");
    }
    return static_cast<std::size_t>(between);
}

void require_one_count(const DensifyOptions& options) {
    if (!options.tolerance) return;
    if (options.between) {
        throw Error("densify.two-counts", "tolerance", format_number(options.tolerance->value),
                    "give a number of points between or a tolerance, not both");
    }
    if (!(options.tolerance->value > 0 && std::isfinite(options.tolerance->value))) {
        throw Error("option.range", "tolerance", format_number(options.tolerance->value),
                    "must be above 0 and finite");
    }
}

void require_moderate(double points) {
    if (!(points <= most_points)) {
        throw Error("densify.too-many", "points", format_number(std::floor(points)),
                    "no more than 1e8 points are made: ask for fewer, or a larger tolerance");
    }
}

/// Steps so small that no cell strays from its chords by more than the tolerance.
Division division_for(const CellCurve& curve, double tolerance) {
    Division division;
    double total = 0;
    for (std::size_t cell = 0; cell < curve.cells(); ++cell) {
        const double bound = curve.second_derivative_bound(cell);
        const double steps = std::max(1.0, std::ceil(std::sqrt(bound / tolerance / 8)));
        total += steps;
        require_moderate(total);
        division.steps.push_back(static_cast<std::size_t>(steps));
    }
    return division;
}

Points divided(const CellCurve& curve, const Division& division) {
    const std::size_t dim = static_cast<std::size_t>(curve.dim());
    std::size_t rows = curve.is_closed() ? 0 : 1;
    for (std::size_t cell = 0; cell < curve.cells(); ++cell) rows += division.of(cell);
    Points points(rows, curve.dim());
    double* out = points.coordinates().data();
    for (std::size_t cell = 0; cell < curve.cells(); ++cell) {
        out = std::copy_n(curve.start(cell), dim, out);
        const double steps = static_cast<double>(division.of(cell));
        for (double i = 1; i < steps; ++i, out += dim) curve.point(cell, i / steps, {out, dim});
    }
    if (!curve.is_closed()) std::copy_n(curve.end(curve.cells() - 1), dim, out);
    return points;
}

DensifyReport report_of(const CellCurve& curve, const Division& division) {
    DensifyReport report;
    report.max_chord_error = largest_chord_error(curve, division);
    report.tangent_jumps = tangent_jumps(curve);
    for (const double jump : report.tangent_jumps) {
        report.max_tangent_jump = std::max(report.max_tangent_jump, std::fabs(jump));
    }
    report.tamed_cells = curve.tamed();
    if (!report.tamed_cells.empty()) {
        report.notes.push_back("cells that strayed from their chord were made anew: " +
                               std::to_string(report.tamed_cells.size()) +
                               "; the points are too unevenly spaced for this parameter there");
    }
    return report;
}

/// The points of a ring without the first one repeated at the end.
PointsView ring(PointsView points, bool closed) {
    const std::size_t n = points.size();
    if (!closed || n < 2) return points;
    const bool repeated = std::equal(points[0].begin(), points[0].end(), points[n - 1].begin());
    return repeated ? points.part(0, n - 1) : points;
}

}  // namespace

Densified densify(PointsView points, const DensifyOptions& options) {
    require_one_count(options);
    const PointsView given = ring(points, options.closed);
    const CellCurve curve(CellMaker(given, options), options.closed);
    Division division{{fixed_between(options) + 1}};
    if (options.tolerance) {
        division = division_for(curve, options.tolerance->in_units(extent(given)));
    }
    require_moderate(static_cast<double>(curve.cells()) * static_cast<double>(division.of(0)));
    Densified result{divided(curve, division), as_curve(curve), report_of(curve, division)};
    result.report.points_in = points.size();
    result.report.points_out = result.points.size();
    if (given.size() < points.size()) {
        result.report.notes.push_back("the last point repeats the first and was left out");
    }
    const double limit = std::numbers::pi / 180;
    if (result.report.max_tangent_jump > limit && !options.blend) {
        result.report.notes.push_back("the tangent jumps by more than a degree: blend, or give "
                                      "more points there");
    }
    return result;
}

std::size_t densified_count(std::size_t points, const DensifyOptions& options) {
    const std::size_t steps = fixed_between(options) + 1;
    return options.closed ? points * steps : (points - 1) * steps + 1;
}

void densify_into(PointsView points, const DensifyOptions& options, std::span<double> out) {
    const CellMaker maker(points, options);
    const std::size_t between = fixed_between(options);
    if (out.size() != densified_count(points.size(), options) * maker.dim()) {
        throw Error("densify.room", "out", std::to_string(out.size()),
                    "densified_count x dimension numbers are needed");
    }
    const std::size_t stride = 1 + maker.terms();
    std::vector<double> factors(between * stride);
    for (std::size_t i = 0; i < between; ++i) {
        const double s = static_cast<double>(i + 1) / static_cast<double>(between + 1);
        put_factors(s, maker.terms(), factors.data() + i * stride);
    }
    double* next = out.data();
    with_size(maker, [&](auto size) {
        return run_cells(size, maker, [&](std::size_t, const double* p, const double* q,
                                          const double* g) {
            next = std::copy_n(p, size.dim, next);
            put_points(size, p, q, g, factors.data(), between, next);
            next += between * size.dim;
        });
    });
    if (!options.closed) std::copy_n(maker.end(maker.cells() - 1), maker.dim(), next);
}

}  // namespace batten
