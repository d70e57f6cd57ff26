#pragma once

#include <cstddef>
#include <vector>

#include "measure/surface/line_pieces.hpp"

/// Which points of lines follow one another.
namespace batten::contouring {

/// What lies between two points, and the points' numbers.
struct Joint {
    std::size_t ends[2] = {0, 0};
    LinePiece piece;
};

/// Pieces in order.
struct Thread {
    std::vector<LinePiece> pieces;
    bool is_closed = false;
};

/// Points, each of at most two joints.
class LineGraph {
public:
    void join(std::size_t a, std::size_t b, const LinePiece& between);
    /// All lines of the first `points` points: first those with ends, then the closed ones, each
    /// by its first point.
    std::vector<Thread> threads(std::size_t points) const;

private:
    std::vector<Joint> joints_;
};

}  // namespace batten::contouring
