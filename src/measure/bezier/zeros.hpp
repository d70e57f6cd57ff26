#pragma once

#include <vector>

#include "measure/bezier/pieces.hpp"

namespace batten::bezier {

/// Collects zeros of a function that is a polynomial on each piece.
class Zeros {
public:
    explicit Zeros(const Pieces& pieces) : pieces_(pieces) {}

    /// The zeros of `c` on piece i, or both ends of the piece if it is 0 all along.
    void add(std::size_t i, bernstein::View c, double noise);

    /// Parameters of the curve, rising; those that pieces share once, likewise the seam.
    std::vector<double> parameters() const;

private:
    struct Zero {
        std::size_t piece;
        double u;
    };

    const Pieces& pieces_;
    std::vector<Zero> zeros_;
};

}  // namespace batten::bezier
