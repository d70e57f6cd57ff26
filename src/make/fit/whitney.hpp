#pragma once

#include <span>
#include <vector>

#include "make/fit/samples.hpp"

/// Whether data determine a spline, exactly: by counting, before any arithmetic.
///
/// The rank of a weighted B-spline matrix is the largest number of functions that can each be
/// given a datum of their own where they are not zero [SchoenbergWhitney1953]; by total positivity
/// this holds for every choice of columns [deBoor2001, XIII]. Open splines only.
namespace batten::fitting {

/// Data at one place of the knot vector, and the functions that are not zero there.
struct Cell {
    int count = 0;  ///< distinct abscissae, at most `order`
    int first = 0;
    int last = 0;
};

/// The cells of a knot vector from left to right: every break, every open interval between.
std::vector<Cell> cells_of(std::span<const double> knots, int order, const Samples& samples);

/// The cells that one interval adds: its left break and its inside (and its right break where it
/// is the last one). `span` is the knot index of its left end.
void add_cells(std::span<const double> knots, int order, std::size_t span, const Samples& samples,
               Rows rows, std::vector<Cell>& out);

/// Distinct abscissae of one interval: at its left end, inside (`order` at most), at its right end
/// (of its rows: so of the last interval only).
struct PlaceCounts {
    int at_left = 0;
    int inside = 0;
    int at_right = 0;
};
PlaceCounts count_places(const Samples& samples, Rows rows, Interval span, int order);

/// The rank where all knots are simple, filled in interval by interval from left to right.
class SimpleRank {
public:
    explicit SimpleRank(int order) : order_(order) {}
    void add(const PlaceCounts& counts);
    int rank() const { return rank_; }

private:
    void give(int count, int first, int last);

    int order_, intervals_ = 0, rank_ = 0, next_ = 0;
};

/// Adds to the distinct abscissae known of one interval, as many as Schoenberg-Whitney can use:
/// order inside, and both ends. They rise.
void remember_places(std::vector<double>& places, std::span<const double> x, Interval span,
                     std::size_t order);

/// The rank of the matrix with `functions` columns, function `without` left out (or -1).
int rank_of(std::span<const Cell> cells, int functions, int without = -1);

/// One a function: whether it depends on those to the left of it.
std::vector<char> dependent_functions(std::span<const Cell> cells, int functions);

/// The coefficients that the data leave open, rising; empty where all are determined.
std::vector<int> undetermined_coefficients(std::span<const Cell> cells, int functions);

}  // namespace batten::fitting
