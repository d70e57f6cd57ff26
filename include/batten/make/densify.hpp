#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// Where the points lie on the parameter axis that Lagrange's polynomials run over.
enum class LagrangeParameter {
    index,        ///< 0, 1, 2, ...: best where the points were laid out smoothly
    chord,        ///< sums of the distances
    centripetal,  ///< sums of their square roots
};

constexpr std::array<Named<LagrangeParameter>, 3> names_of(LagrangeParameter) {
    return {{{"index", LagrangeParameter::index},
             {"chord", LagrangeParameter::chord},
             {"centripetal", LagrangeParameter::centripetal}}};
}

struct DensifyOptions {
    int degree = 3;
    std::optional<int> end_degree;
    std::optional<int> between;
    std::optional<Tolerance> tolerance;
    LagrangeParameter parameter = LagrangeParameter::index;
    std::vector<double> parameter_values;
    bool closed = false;
    bool blend = false;
    bool keep_spikes = false;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, DensifyOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("degree", o.degree, between(1, 15),
          "degree of the polynomials; above 8 they swing at the ends");
    visit("end_degree", o.end_degree, between(1, 15),
          "degree where the points run out on one side; 2 is good where curvature is strong there");
    visit("between", o.between, between(0, 1e6),
          "number of new points in each cell (3 unless a tolerance is given)");
    visit("tolerance", o.tolerance, more_than(0),
          "largest distance of the curve from the chords of the new points");
    visit("parameter", o.parameter, anything, "how the points are spaced on the parameter axis");
    visit("parameter_values", o.parameter_values, anything,
          "the parameter of each point; closed, one more: the period's end");
    visit("closed", o.closed, anything, "the points are a ring");
    visit("blend", o.blend, anything, "blend neighbouring polynomials: no tangent jumps");
    visit("keep_spikes", o.keep_spikes, anything, "leave cells alone that stray from their chord");
}

struct DensifyReport {
    std::size_t points_in = 0;
    std::size_t points_out = 0;
    double max_chord_error = 0;
    double max_tangent_jump = 0;
    std::vector<double> tangent_jumps;
    std::vector<std::size_t> tamed_cells;
    Status status = Status::met;
    std::vector<std::string> notes;
};

template <class Visit>
void visit_fields(const DensifyReport& r, Visit&& visit) {
    visit("points_in", r.points_in, "number of points given");
    visit("points_out", r.points_out, "number of points made");
    visit("max_chord_error", r.max_chord_error,
          "largest distance of the interpolating curve from the chords of the new points");
    visit("max_tangent_jump", r.max_tangent_jump,
          "largest angle between the tangents on both sides of a given point");
    visit("tangent_jumps", r.tangent_jumps,
          "these angles, from the second point (closed: the first) on; in the plane signed, "
          "positive to the left");
    visit("tamed_cells", r.tamed_cells, "cells that strayed from their chord and were made anew");
    visit("notes", r.notes, "what was done that was not asked for");
}

struct Densified {
    Points points;
    Curve curve;  ///< the interpolating curve, over the parameters used
    DensifyReport report;
};

/// More points on the curve that moving windows of Lagrange polynomials make of the given ones, in
/// any dimension. The given points are kept bit for bit.
///
/// Cell k, from point k to k + 1 of n cells, takes the degree m polynomial through points
/// i0 ... i0 + m, i0 = clamp(k - floor((m - 1) / 2), 0, n - m); closed, the window goes round.
/// So degree 2 looks forward, the last cell backward; degree 3 is central, the end cells forward
/// and backward [Nakajima, eqs. 5-14]. `end_degree` serves the first, the last and every cell
/// whose window was clamped.
/// New points: `between` K at j / (K + 1) of each cell's parameter, or N equal steps a cell,
/// N = ceil(sqrt(max |f''| / (8 tolerance))): then no point of the curve is further than the
/// tolerance from its chord. max |f''| is exact up to degree 3, a Bernstein bound beyond.
///
/// The curve is continuous; its tangent jumps at the given points (reported). `blend` takes
/// (1 - s) times the polynomial centred at point k plus s times the one at k + 1: C1 in the
/// parameter, degree m + 1 [Overhauser1968].
///
/// Uneven spacing can throw a polynomial far off its chord. A cell is tamed, unless `keep_spikes`,
/// where its curve is further from the middle of its chord than the chord is long (looked at in 16
/// steps; an arc needs 254 degrees for that): its window is taken again with
/// centripetal, then with chord parameters, and at last the cell is made straight.
///
/// Cost: about 0.2 us a point, nearly all of it for the report; `densify_into` makes points alone.
/// Accuracy: 4 ulps x the Lebesgue constant of the window x the points' largest coordinate.
/// Laws: points x 2^k give results x 2^k exactly.
/// Throws `points.not-finite`, `points.repeated`, `points.too-few` (degree + 1, closed also 3),
/// `lagrange.parameter-count`, `lagrange.parameters-not-increasing`, `densify.two-counts` for both
/// between and tolerance, `densify.blend-degree` for a blend below degree 2, `densify.too-many`
/// beyond 10^8 points, `option.range`, `number.overflow`.
Densified densify(PointsView points, const DensifyOptions& options);

/// How many points `densify_into` writes.
std::size_t densified_count(std::size_t points, const DensifyOptions& options);

/// The points of `densify` alone, bit for bit, into `out` (densified_count x dim numbers), for a
/// fixed number `between`. No report, and no allocation for index parameters.
///
/// Cost: about 1.4 ns a point of the plane (cubic, index parameters, 3 between); 22 ns with other
/// parameters.
void densify_into(PointsView points, const DensifyOptions& options, std::span<double> out);

/// The factors of the points at `nodes` in the value at t of the polynomial through all of them.
/// Exact where products of the nodes' differences and their quotient are: for integer nodes and
/// t a multiple of 1/4 those of [Nakajima, eqs. 6, 8, 10, 12, 14].
/// Throws `lagrange.parameters-not-increasing` unless the nodes rise strictly.
std::vector<double> lagrange_weights(std::span<const double> nodes, double t);

}  // namespace batten
