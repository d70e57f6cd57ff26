#pragma once

#include <vector>

#include "make/fit/interval_rows.hpp"
#include "make/fit/triangle.hpp"

/// Triangles of the halves, quarters, ... of an interval: any knot vector after one pass.
namespace batten::fitting {

/// A binary tree of intervals halved down to about `leaf_rows` samples. Triangles merge exactly (to
/// rounding), so what a spline needs to know of any interval costs O(leaf_rows + log N).
class ReductionTree {
public:
    static constexpr std::size_t leaf_rows = 512;

    struct Node {
        Interval span;
        Rows rows;
        int left = -1;  ///< the right half is left + 1
    };

    ReductionTree(const Reducer& reducer, Interval domain);

    const Node& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }
    const double* triangle(int i) const {
        return triangles_.data() + static_cast<std::size_t>(i) * reducer_.shape().size();
    }
    /// The triangle over any part of the domain.
    void over(Interval span, RightEnd end, double* out) const;

private:
    void grow(int node);
    void collect(int node, Interval span, RightEnd end, double* out) const;

    const Reducer& reducer_;
    std::vector<Node> nodes_;
    std::vector<double> triangles_;
};

/// The middle as the paper takes it: (lo + hi) / 2.
inline double knot_between(Interval span) { return 0.5 * (span.lo + span.hi); }

}  // namespace batten::fitting
