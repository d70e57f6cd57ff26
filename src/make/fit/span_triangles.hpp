#pragma once

#include <memory>
#include <vector>

#include "make/fit/tree.hpp"

namespace batten::fitting {

/// The triangles of any intervals of one set of samples, those used lately from memory.
class SpanTriangles {
public:
    SpanTriangles(const Samples& samples, const LocalBasis& basis);

    const TriangleShape& shape() const { return reducer_.shape(); }
    /// `rows`: those in `span`. Valid until the next call.
    const double* triangle(Interval span, Rows rows, RightEnd end);

private:
    struct Cached {
        double lo = 0, hi = -1;
        std::vector<double> triangle;
    };
    Reducer reducer_;
    std::unique_ptr<ReductionTree> tree_;
    std::vector<Cached> cache_;
};

}  // namespace batten::fitting
