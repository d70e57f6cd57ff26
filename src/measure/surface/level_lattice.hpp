#pragma once

#include <cstddef>
#include <vector>

#include "measure/surface/lattice.hpp"
#include "measure/surface/line_graph.hpp"
#include "measure/surface/line_pieces.hpp"
#include "shape/surface/sheet.hpp"

namespace batten::contouring {

/// Where a level crosses an edge: the place, and how far along the edge, in shares of the interval
/// or in y.
struct Crossing {
    double x = 0, y = 0;
    double along = 0;
};

/// A part of a cell of the lattice: its column, shares of the interval, ordinates. Sides below,
/// right, above, left; corners before each of them, counter-clockwise.
struct CellPart {
    std::size_t column = 0;
    Interval share, y;
    bool is_above[4] = {};
    std::vector<std::size_t> crossings[4];  ///< from the lower to the upper end of a side
    int halvings = 0;

    std::size_t count() const;
};

/// One level of one surface: where it crosses the edges of a lattice, and how the crossings are
/// joined within cells. Cells in which that is not certain are quartered until it is.
class LevelLattice {
public:
    LevelLattice(const surfaces::Sheet& sheet, double level, double tolerance);

    const surfaces::Sheet& sheet() const { return sheet_; }
    /// Whether the lines between are certain, or at least closer together than the tolerance.
    bool is_certain() const { return is_certain_; }
    /// Heights less the level that are no more than this are rounding.
    double noise() const { return noise_; }
    std::vector<Thread> threads() const { return graph_.threads(crossings_.size()); }

    surfaces::SheetColumn column(std::size_t c) const {
        return surfaces::Sheet::column_after(lattice_.lines[c]);
    }
    double place(std::size_t line, double y) const {
        return surfaces::Sheet::place(lattice_.lines[line], sheet_.knots(y));
    }
    std::size_t interval(std::size_t c) const { return lattice_.lines[c].interval; }
    /// A point and the direction of the line there, seen from column `c`.
    LinePoint point_in(std::size_t c, double x, double y) const;

private:
    struct Edge {
        std::size_t i = 0, j = 0;
        bool is_along_x = true;
    };

    LinePoint end_point(std::size_t c, const Crossing& end, const Crossing& other) const;
    LinePoint point_on_wall(std::size_t c, double x, double y) const;
    double height(std::size_t column, double share, double y) const;
    double share_at(std::size_t line, std::size_t column) const;
    void find_crossings(const Edge& edge);
    void join_cell(std::size_t i, std::size_t j);
    void join_wall(const CellPart& cell);
    void join_part(const CellPart& part);
    void join_ends(const CellPart& part);
    void quarter(const CellPart& part);
    bool is_small(const CellPart& part) const;
    bool may_hide_more(const CellPart& part) const;
    LinePiece piece_between(std::size_t a, std::size_t b, std::size_t column) const;
    void join(std::size_t a, std::size_t b, std::size_t column);
    bool join_plainly(const std::size_t (&ends)[2], std::size_t column);
    CellPart cell_at(std::size_t i, std::size_t j) const;
    std::vector<std::size_t> crossings_of(const Edge& edge) const;
    std::vector<std::size_t> inner_crossings(const CellPart& part, bool is_along_x, double at,
                                             Interval range, bool lo_is_above, bool hi_is_above);

    const surfaces::Sheet& sheet_;
    double level_, tolerance_;
    Lattice lattice_;
    std::vector<std::vector<double>> knots_;  ///< of each row
    Grid heights_;                            ///< less the level
    LatticeBends bends_;
    double noise_ = 0;
    bool has_kinks_;
    std::vector<Crossing> crossings_;
    std::vector<std::size_t> first_;  ///< of each edge, two a node; one more
    LineGraph graph_;
    std::size_t parts_left_;
    bool is_certain_ = true;
};

}  // namespace batten::contouring
