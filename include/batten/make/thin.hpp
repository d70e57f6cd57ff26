#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/make/densify.hpp"

namespace batten {

struct ThinOptions {
    Tolerance tolerance = relative(1e-3);
    int degree = 3;
    std::optional<int> end_degree;
    LagrangeParameter parameter = LagrangeParameter::index;
    bool closed = false;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, ThinOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("tolerance", o.tolerance, more_than(0),
          "largest distance between the curve of all points and that of the kept ones");
    visit("degree", o.degree, between(1, 15), "degree of the polynomials the curves are made of");
    visit("end_degree", o.end_degree, between(1, 15), "degree where the points run out on one side");
    visit("parameter", o.parameter, anything, "how the points are spaced on the parameter axis");
    visit("closed", o.closed, anything, "the points are a ring");
}

/// A run of given points too far apart for the tolerance, whatever is kept.
struct ShortageRecord {
    std::size_t from = 0;
    std::size_t to = 0;
    double error = 0;
    double times = 1;
};

template <class Visit>
void visit_fields(const ShortageRecord& r, Visit&& visit) {
    visit("from", r.from, "first point of the run, from 0");
    visit("to", r.to, "last point of the run");
    visit("error", r.error, "how much the curve still changes there with the next higher degree");
    visit("times", r.times, "so many cells in place of one would bring that below the tolerance");
}

struct ThinReport {
    std::size_t points_in = 0;
    std::size_t points_out = 0;
    double max_error = 0;
    std::vector<ShortageRecord> shorter_cells;
    Status status = Status::met;
    std::vector<std::string> notes;
};

template <class Visit>
void visit_fields(const ThinReport& r, Visit&& visit) {
    visit("points_in", r.points_in, "number of points given");
    visit("points_out", r.points_out, "number of points kept");
    visit("max_error", r.max_error,
          "largest distance between the curve of all points and that of the kept ones");
    visit("shorter_cells", r.shorter_cells,
          "where curvature wants shorter cells than were given: the curve itself is not yet sure "
          "within the tolerance");
    visit("notes", r.notes, "what was done that was not asked for");
}

struct Thinned {
    Points points;
    std::vector<std::size_t> kept;  ///< their rows in the input, rising
    ThinReport report;
};

/// Few of the given points from which `densify`, with the same degree and parameter, makes the
/// curve again within the tolerance, in any dimension. The ends (closed: point 0) are kept.
///
/// The two curves' distance is measured both ways, at 4 places of each given cell and at the
/// places of the new curve half way between the nearest to those.
/// Fewest: a search, not a proof. Two starts, all points (up to 2000) and the smallest set whose
/// spacing follows the curve's own density (error evened out in rounds), are thinned one by one
/// while the tolerance allows; the smaller result is taken. Against all choices of kept points of
/// short rows it keeps at most one more (tests/known/thin_test.cpp).
/// Laws: points x 2^k keep the same rows. Throws what `densify` throws.
/// Cost: about 10 us for each point dropped one by one; 1 us x 4 log2(n) a point for the density.
Thinned thin(PointsView points, const ThinOptions& options);

}  // namespace batten
